#include "seedFiles.H"

#include "case/caseFileIO.H"

#include <fmt/format.h>

#include <cmath>

namespace gpuFsi
{

namespace
{

std::vector<double> evaluateRho
(
    const seedField& field,
    const std::vector<vector>& points
)
{
    std::vector<double> rho = field.components[0].at(points);
    for (std::size_t i = 0; i < rho.size(); ++i)
    {
        if (!(rho[i] > 0))
        {
            const vector& p = points[i];
            throw userError
            (
                fmt::format
                (
                    "rho is {} at ({} {} {})", rho[i], p.x, p.y, p.z
                ),
                field.where,
                "A density is positive everywhere."
            );
        }
    }
    return rho;
}

void addField(cloud& to, const seedField& field)
{
    if (field.name == "rho")
    {
        to.addScalar("rho", evaluateRho(field, to.positions));
        return;
    }
    const std::size_t n = field.components.size();
    if (n == 1)
    {
        to.addScalar(field.name, field.components[0].at(to.positions));
        return;
    }
    cloudField vectors{"vectorField", field.name, {}};
    vectors.values.resize(n*to.size());
    for (std::size_t c = 0; c < n; ++c)
    {
        const std::vector<double> one = field.components[c].at(to.positions);
        for (std::size_t i = 0; i < one.size(); ++i)
        {
            vectors.values[n*i + c] = one[i];
        }
    }
    to.fields.push_back(std::move(vectors));
}

//- The bulk goes along
cloud makeFluid(const seedSettings& settings, seededParticles& seeded)
{
    cloud fluid;
    fluid.name = "fluid";
    fluid.positions = std::move(seeded.bulk);
    for (const seedField& field : settings.fields)
    {
        addField(fluid, field);
    }
    const lattice& l = *settings.mesh;
    std::vector<double> mass = fluid.find("rho")->values;
    for (double& m : mass)
    {
        m *= std::pow(l.h(), l.dimensions());
    }
    fluid.addScalar("m", std::move(mass));
    return fluid;
}

cloud makeWalls
(
    const seedSettings& settings,
    const seededParticles& seeded,
    const seededSolids& solids
)
{
    cloud walls;
    walls.name = "walls";
    std::vector<vector> normals;
    std::vector<double> areas;
    std::vector<double> patches;
    std::vector<double> nodes;
    std::vector<vector> U;
    for (const wallParticle& w : seeded.walls)
    {
        walls.positions.push_back(w.position);
        normals.push_back(w.normal);
        areas.push_back(w.area);
        patches.push_back(w.patch);
        nodes.push_back(w.node);
        // Walls rest until their motion is given to the solver
        U.push_back(w.node < 0 ? vector{0, 0, 0} : solids.U[w.node]);
    }
    for (const seedField& field : settings.fields)
    {
        if (field.name == "rho")
        {
            addField(walls, field);
        }
    }
    walls.addVector("U", U);
    walls.addVector("normal", normals);
    walls.addScalar("area", std::move(areas));
    walls.addLabel("patch", std::move(patches));
    if (!solids.mesh.empty())
    {
        walls.addLabel("node", std::move(nodes));
    }
    return walls;
}

cloud makeSolid(const seededSolids& solids)
{
    cloud solid;
    solid.name = "solid";
    solid.positions = solids.mesh.points;
    solid.addVector("U", solids.U);
    solid.addVector("referencePosition", solids.mesh.points);
    return solid;
}

//- Goes aside, to be removed with it
void removeFolder
(
    const std::filesystem::path& aside,
    const std::filesystem::path& casePath,
    const std::string& name
)
{
    if (std::filesystem::exists(casePath/name))
    {
        const std::filesystem::path former = aside/"former"/name;
        // A folder to rename onto: a file in its place is not ours to remove
        std::filesystem::create_directories(former);
        std::filesystem::rename(casePath/name, former);
    }
}

void replaceFolder
(
    const std::filesystem::path& aside,
    const std::filesystem::path& casePath,
    const std::string& name
)
{
    removeFolder(aside, casePath, name);
    std::filesystem::rename(aside/name, casePath/name);
}

} // namespace

writeOptions readWriteOptions(const std::filesystem::path& casePath)
{
    const dictionary dict =
        dictionary::fromFile(casePath/"system/controlDict");
    writeOptions options;
    options.binary =
        dict.getChoiceOrDefault("writeFormat", "binary", {"ascii", "binary"})
     == "binary";
    options.precision =
        int(dict.getNumberOrDefault("writePrecision", 6, 1, 17));
    const std::string compression = dict.getChoiceOrDefault
    (
        "writeCompression",
        "off",
        {
            "on", "off", "true", "false", "yes", "no", "y", "n", "t", "f",
            "compressed", "uncompressed"
        }
    );
    for (const char* on : {"on", "true", "yes", "y", "t", "compressed"})
    {
        options.compress |= compression == on && !options.binary;
    }
    return options;
}


std::vector<cloud> makeClouds
(
    const seedSettings& settings,
    seededParticles& seeded,
    const seededSolids& solids
)
{
    std::vector<cloud> clouds;
    if (settings.fluid)
    {
        clouds.push_back(makeFluid(settings, seeded));
        clouds.push_back(makeWalls(settings, seeded, solids));
    }
    if (!solids.mesh.empty())
    {
        clouds.push_back(makeSolid(solids));
    }
    return clouds;
}


domain makeDomain
(
    const seedSettings& settings,
    const seededParticles& seeded,
    const seededSolids& solids
)
{
    const lattice& l = *settings.mesh;
    domain d;
    d.dimensions = l.dimensions();
    d.spacing = l.h();
    d.lo = l.lo();
    d.hi = l.hi();
    d.periodic = {l.periodic(0), l.periodic(1), l.periodic(2)};
    d.volume = seeded.volume;
    for (const auto& region : settings.regions)
    {
        d.walls.push_back(region->name());
    }
    d.solids = solids.mesh.names;
    for (const solidMesh::partName& p : solids.mesh.parts)
    {
        d.solidParts.push_back({d.solids[p.solid], p.name});
    }
    return d;
}


std::size_t writeSeed
(
    const std::filesystem::path& casePath,
    const std::vector<cloud>& clouds,
    const domain& d,
    const solidMesh& solids,
    const writeOptions& options
)
{
    namespace fs = std::filesystem;
    std::size_t bytes = 0;

    // Headers name the time folder: write into one of that name
    const fs::path aside = casePath/".seedParticles.partial";
    fs::remove_all(aside);
    try
    {
        for (const cloud& c : clouds)
        {
            writeOptions own = options;
            if (c.name == "solid")
            {
                own.precision = 17;    // a rounded place would be a strain
            }
            bytes += writeCloud(aside/"0", c, own);
        }
        d.write(aside);
        if (!solids.empty())
        {
            bytes += solids.write(aside, options);
        }
        const double half = 0.5*d.spacing;
        const vector margin{half, half, half};
        writeBoxMesh(aside, d.lo - margin, d.hi + margin);

        fs::create_directories(casePath/"0");
        fs::create_directories(casePath/"constant");
        replaceFolder(aside, casePath, "0/lagrangian");
        replaceFolder(aside, casePath, "constant/polyMesh");
        if (solids.empty())
        {
            removeFolder(aside, casePath, "constant/solid");
        }
        else
        {
            replaceFolder(aside, casePath, "constant/solid");
        }
        fs::rename(aside/"constant/domain", casePath/"constant/domain");
        writeReaderFiles(casePath);
    }
    catch (const fs::filesystem_error& e)
    {
        std::error_code ignored;
        fs::remove_all(aside, ignored);
        throw userError
        (
            std::string("Cannot write the case: ") + e.what(),
            {},
            "Check the disk and the permissions of the case directory."
        );
    }
    catch (...)
    {
        std::error_code ignored;
        fs::remove_all(aside, ignored);
        throw;
    }
    fs::remove_all(aside);
    return bytes;
}

} // namespace gpuFsi
