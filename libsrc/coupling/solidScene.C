#include "coupling/solidScene.H"

#include <algorithm>

namespace gpuFsi
{

namespace fs = std::filesystem;

couplingProperties couplingProperties::read(const fs::path& casePath)
{
    couplingProperties p;
    const fs::path file = casePath/"constant"/"couplingProperties";
    if (!fs::exists(file))
    {
        return p;
    }
    const dictionary dict = dictionary::fromFile(file);
    p.force = dict.getChoiceOrDefault
    (
        "force", "surface", {"surface", "reaction"}
    ) == "reaction" ? law::reaction : law::surface;
    if (dict.found("referencePressure"))
    {
        p.referencePressure =
            dict.getDimensioned("referencePressure", dimensions::pressure);
    }
    dict.warnUnread();
    return p;
}


static solidMesh readMesh(const fs::path& casePath, const domain& d)
{
    solidMesh mesh;
    mesh.dimensions = d.dimensions;
    mesh.names = d.solids;
    for (const domain::solidPart& p : d.solidParts)
    {
        const auto at = std::find(d.solids.begin(), d.solids.end(), p.solid);
        mesh.parts.push_back({int(at - d.solids.begin()), p.name});
    }
    const vector length = d.hi - d.lo;
    mesh.period =
    {
        d.periodic[0] ? length.x : 0,
        d.periodic[1] ? length.y : 0,
        d.periodic[2] && d.dimensions == 3 ? length.z : 0
    };
    mesh.read(casePath);
    return mesh;
}


std::unique_ptr<solidScene> solidScene::read
(
    const fs::path& casePath,
    const domain& d
)
{
    if (d.solids.empty())
    {
        return nullptr;
    }
    auto scene = std::make_unique<solidScene>();
    scene->mesh = readMesh(casePath, d);
    scene->properties = solidProperties::read(casePath, scene->mesh);
    if (d.hasFluid())
    {
        scene->coupling = couplingProperties::read(casePath);
    }
    return scene;
}

} // namespace gpuFsi
