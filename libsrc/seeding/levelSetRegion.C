#include "seeding/levelSetRegion.H"

namespace gpuFsi
{

levelSetRegion::levelSetRegion(const regionInput& input)
:
    implicitRegion(input, false),
    expression_
    (
        input.dict.get<std::string>("expression"),
        input.dict.where("expression")
    )
{}


std::string levelSetRegion::description() const
{
    return "level set " + expression_.text() + sideText();
}

} // namespace gpuFsi
