#include "solid/solidProperties.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace gpuFsi
{

namespace fs = std::filesystem;

static constexpr double unlimited = std::numeric_limits<double>::max();

static constexpr dimensionSet dimTime{0, 0, 1, 0, 0, 0, 0};


//- lambda, mu and what central springs leave over
static void readModuli(const dictionary& d, int D, solidMaterial& m)
{
    m.planeStress = D == 2
     && d.getChoiceOrDefault("plane", "strain", {"strain", "stress"})
     == "stress";
    const double own = m.planeStress ? 1.0/3 : 1.0/4;
    const double E = d.getPositive("E", dimensions::pressure);
    const double nu = d.getNumberOrDefault("nu", own, 0, 0.499);
    m.mu = E/(2*(1 + nu));
    m.lambda = E*nu/((1 + nu)*(1 - 2*nu));
    if (m.planeStress)
    {
        m.lambda = 2*m.lambda*m.mu/(m.lambda + 2*m.mu);
    }
    const bool central = std::fabs(nu - own) < 1e-9;
    m.kappa = central ? 0 : m.lambda - m.mu;
    if (!d.getOrDefault("volumetric", true) && !central)
    {
        throw userError
        (
            fmt::format
            (
                "Central springs alone have nu = {:.6g}, not {:g}", own, nu
            ),
            d.where("nu"),
            "Set that nu, or 'volumetric on'."
        );
    }
}


static solidMaterial readMaterial(const dictionary& d, int D)
{
    solidMaterial m;
    m.rho = d.getPositive("rho", dimensions::density);
    m.uniform = d.getChoiceOrDefault
    (
        "springs", "isotropic", {"isotropic", "uniform"}
    ) == "uniform";
    if (m.uniform)
    {
        m.k = d.getNumber("k", 0, unlimited);
        if (!(m.k > 0))
        {
            throw userError
            (
                fmt::format("Entry 'k' is {}, but must be positive", m.k),
                d.where("k")
            );
        }
    }
    else
    {
        readModuli(d, D, m);
    }
    m.dashpot = d.getNumberOrDefault("dashpot", 0, 0, unlimited);
    m.friction = d.getNumberOrDefault("friction", 0, 0, unlimited);
    m.viscous = d.getNumberOrDefault("viscous", 0, 0, unlimited);
    if (d.found("breakStrain"))
    {
        m.breakStrain = d.getPositive("breakStrain", dimensionSet{});
    }
    return m;
}


static vector unitNormal(const dictionary& d)
{
    const vector n = d.get<vector>("normal");
    const double length = std::sqrt(dot(n, n));
    if (!(length > 0))
    {
        throw userError
        (
            "The normal of a plane must not be zero", d.where("normal")
        );
    }
    return (1/length)*n;
}


//- Would a part of a plane solid leave the plane?
static bool leavesPlane(const solidPart& p)
{
    bool leaves = p.normal.z != 0 || p.traction.z != 0 || p.force.z != 0;
    if (p.motion)
    {
        // Of an oscillation one of velocity and acceleration is never zero
        const rigidState s = p.motion->at(0);
        leaves = leaves || s.velocity.z != 0 || s.acceleration.z != 0
          || s.omega.x != 0 || s.omega.y != 0;
    }
    return leaves;
}


static vector anchorStiffness(const dictionary& d)
{
    const vector k = d.get<vector>("stiffness");
    if (!(k.x >= 0 && k.y >= 0 && k.z >= 0))
    {
        throw userError
        (
            fmt::format
            (
                "stiffness is ({:g} {:g} {:g}), but must not be negative",
                k.x, k.y, k.z
            ),
            d.where("stiffness"),
            "Give the stiffness in x, y and z, N/m."
        );
    }
    return k;
}


static solidPart readPart(const dictionary& d, int D)
{
    solidPart p;
    std::vector<std::string> words = wallMotion::table::words();
    words.insert
    (
        words.end(), {"fixed", "slide", "pressure", "traction", "force", "anchor"}
    );
    words.erase(std::find(words.begin(), words.end(), "sliding"));
    const std::string word = d.getChoice("type", words);
    if (word == "fixed")
    {
        p.kind = solidPart::type::fixed;
    }
    else if (word == "slide")
    {
        p.kind = solidPart::type::slide;
        p.normal = unitNormal(d);
    }
    else if (word == "pressure")
    {
        p.pressure = d.getDimensioned("pressure", dimensions::pressure);
    }
    else if (word == "traction")
    {
        p.traction =
            d.getDimensionedVector("traction", dimensions::pressure);
    }
    else if (word == "force")
    {
        p.force = d.get<vector>("force");
    }
    else if (word == "anchor")
    {
        p.anchor = anchorStiffness(d);
    }
    else
    {
        p.kind = solidPart::type::driven;
        p.motion = wallMotion::make(d);
    }
    p.ramp = d.found("ramp") ? d.getPositive("ramp", dimTime) : 0;
    if (D == 2 && leavesPlane(p))
    {
        throw userError
        (
            fmt::format("A part of type {} leaves the plane in 2-D", word),
            d.where("type"),
            "Set z components to 0 and turn about the z axis alone."
        );
    }
    return p;
}


static void readParts
(
    const dictionary& d,
    int solid,
    const solidMesh& mesh,
    std::vector<solidPart>& parts
)
{
    std::vector<std::string> known;
    for (const auto& p : mesh.parts)
    {
        if (p.solid == solid)
        {
            known.push_back(p.name);
        }
    }
    for (const std::string& key : d.keys())
    {
        if (std::find(known.begin(), known.end(), key) == known.end())
        {
            throw userError
            (
                unknownChoice("part of the solid", key, known), d.where(key)
            );
        }
    }
    for (std::size_t p = 0; p < mesh.parts.size(); ++p)
    {
        const std::string& name = mesh.parts[p].name;
        if (mesh.parts[p].solid == solid && d.found(name))
        {
            parts[p] = readPart(d.subDict(name), mesh.dimensions);
        }
    }
}


solidProperties solidProperties::read
(
    const dictionary& dict,
    const bodyForce& g,
    const solidMesh& mesh
)
{
    solidProperties p;
    p.g = g;
    if (mesh.dimensions == 2 && g.acts(2))
    {
        throw userError
        (
            "Gravity has a z component in 2-D",
            {},
            "Set it to 0 in constant/g."
        );
    }
    p.parts.resize(mesh.parts.size());
    for (std::size_t s = 0; s < mesh.names.size(); ++s)
    {
        const dictionary& d = dict.subDict(mesh.names[s]);
        p.materials.push_back(readMaterial(d, mesh.dimensions));
        if (const dictionary* parts = d.subDictPtr("parts"))
        {
            readParts(*parts, int(s), mesh, p.parts);
        }
    }
    const std::string word = dict.getChoiceOrDefault
    (
        "stepping", "automatic", {"automatic", "explicit", "implicit"}
    );
    p.stepping = word == "explicit" ? scheme::verlet
      : word == "implicit" ? scheme::midpoint : scheme::automatic;
    p.tolerance =
        dict.getNumberOrDefault("tolerance", p.tolerance, 1e-12, 0.01);
    if (dict.found("subSteps"))
    {
        const double n = dict.getNumber("subSteps", 1, 1e6);
        p.subSteps = int(n);
    }
    p.contact = contactProperties::read(dict, mesh.names);
    if (p.contact.active && p.stepping == scheme::midpoint)
    {
        throw userError
        (
            "Implicit steps have no contact",
            dict.where("stepping"),
            "Set 'stepping explicit', or 'active no' in contact."
        );
    }
    dict.warnUnread();
    return p;
}


solidProperties solidProperties::read
(
    const fs::path& casePath,
    const solidMesh& mesh
)
{
    return read
    (
        dictionary::fromFile(casePath/"constant"/"solidProperties"),
        bodyForce::read(casePath), mesh
    );
}

} // namespace gpuFsi
