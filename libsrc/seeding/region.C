#include "seeding/region.H"

#include "seeding/levelSetRegion.H"
#include "seeding/pointsRegion.H"
#include "seeding/shapes.H"

#include <algorithm>

namespace gpuFsi
{

namespace
{

const regionSelection::add<boxRegion> addBox("box");
const regionSelection::add<sphereRegion> addSphere("sphere");
const regionSelection::add<cylinderRegion> addCylinder("cylinder");
const regionSelection::add<planeRegion> addPlane("plane");
const regionSelection::add<levelSetRegion> addLevelSet("levelSet");
const regionSelection::add<pointsRegion> addPoints("points");

} // namespace

region::region(const regionInput& input)
:
    name_(input.name),
    where_(input.dict.where()),
    fluidInside_
    (
        input.dict.getChoiceOrDefault("side", "inside", {"inside", "outside"})
     == "inside"
    )
{}


std::unique_ptr<region> makeRegion(const regionInput& input)
{
    const std::string type = input.dict.get<std::string>("type");
    const sourceSpan where = input.dict.where("type");
    const auto known = regionSelection::words();
    if
    (
        type == "surface"
     && std::find(known.begin(), known.end(), type) == known.end()
    )
    {
        throw userError
        (
            "This build reads no surface meshes: CGAL was not found when it"
            " was configured",
            where,
            "Install CGAL (Debian, Ubuntu: apt-get install libcgal-dev) and"
            " build again, or use a region of another type."
        );
    }
    return regionSelection::make("region", type, where, input);
}

} // namespace gpuFsi
