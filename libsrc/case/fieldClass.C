#include "case/fieldClass.H"

namespace gpuFsi
{

const std::vector<fieldClass>& fieldClasses()
{
    static const std::vector<fieldClass> all
    {
        {"scalarField", 1, false},
        {"labelField", 1, true},
        {"vectorField", 3, false},
        {"symmTensorField", 6, false},
        {"tensorField", 9, false}
    };
    return all;
}

const fieldClass* findFieldClass(const std::string& name)
{
    for (const fieldClass& candidate : fieldClasses())
    {
        if (candidate.name == name)
        {
            return &candidate;
        }
    }
    return nullptr;
}

} // namespace gpuFsi
