#include "particles/stateIO.H"

#include "case/cloudView.H"
#include "particles/needField.H"
#include "particles/solidIO.H"

#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

//- Pressure follows from density
static const cloudRequest fluidRequest{{"p"}, {"U"}};

static void checkPositive
(
    const std::vector<double>& values,
    const std::string& field,
    const fs::path& file
)
{
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        if (!(values[i] > 0))
        {
            throw userError
            (
                fmt::format
                (
                    "{} of particle {} is {}, but must be positive",
                    field, i, values[i]
                ),
                {file.string()}
            );
        }
    }
}


//- deltaRho where it was written, which must agree with rho; else rho - rho0
static std::vector<double> takeDeltaRho
(
    cloud& c,
    double rho0,
    const fs::path& time
)
{
    const std::vector<double> rho =
        takeValues(c, "rho", "scalarField", time);
    const fs::path directory = time/"lagrangian"/c.name;
    checkPositive(rho, "rho", directory/"rho");

    std::vector<double> delta;
    if (c.find("deltaRho"))
    {
        delta = takeValues(c, "deltaRho", "scalarField", time);
    }
    else
    {
        delta = rho;
        for (double& d : delta)
        {
            d -= rho0;
        }
    }
    for (std::size_t i = 0; i < rho.size(); ++i)
    {
        if (std::abs(rho0 + delta[i] - rho[i]) > 1e-5*rho[i])
        {
            throw userError
            (
                fmt::format
                (
                    "rho = {} of particle {} is not rho0 + deltaRho = {} + {}",
                    rho[i], i, rho0, delta[i]
                ),
                {(directory/"rho").string()},
                "Remove the file deltaRho to start from rho, or restore rho0 "
                "in constant/fluidProperties."
            );
        }
    }
    return delta;
}


//- Its values go along
static particleSet takeSet(cloud& c, double rho0, const fs::path& time)
{
    particleSet s;
    s.U = takeVectors(c, "U", time);
    s.deltaRho = takeDeltaRho(c, rho0, time);
    s.positions = std::move(c.positions);
    return s;
}


bool isInside(const vector& x, const domain& d)
{
    const double slack = 0.5*d.spacing;
    const auto inside = [&](double x, double lo, double hi)
    {
        return x >= lo - slack && x <= hi + slack;
    };
    return inside(x.x, d.lo.x, d.hi.x) && inside(x.y, d.lo.y, d.hi.y)
     && (d.dimensions == 2 || inside(x.z, d.lo.z, d.hi.z));
}


static void checkInside(const particleSet& s, const domain& d, const fs::path& f)
{
    for (std::size_t i = 0; i < s.size(); ++i)
    {
        const vector& x = s.positions[i];
        if (!isInside(x, d))
        {
            throw userError
            (
                fmt::format
                (
                    "Particle {} at ({:g} {:g} {:g}) lies outside the domain "
                    "({:g} {:g} {:g}) to ({:g} {:g} {:g})",
                    i, x.x, x.y, x.z, d.lo.x, d.lo.y, d.lo.z,
                    d.hi.x, d.hi.y, d.hi.z
                ),
                {f.string()},
                "Widen bounds in system/seedParticlesDict and seed again, or "
                "start from an earlier time."
            );
        }
    }
}


//- Particles of the solids that wall particles are
static std::vector<int> nodesOf
(
    const cloud& walls,
    std::size_t nSolid,
    const fs::path& time
)
{
    std::vector<int> nodes;
    for (double n : needField(walls, "node", "labelField", time).values)
    {
        if (n < -1 || n >= double(nSolid))
        {
            throw userError
            (
                fmt::format
                (
                    "Node {} is not one of the {} particles of the solids",
                    n, nSolid
                ),
                {(time/"lagrangian/walls/node").string()},
                "Clouds walls and solid must come from the same seedParticles."
            );
        }
        nodes.push_back(int(n));
    }
    return nodes;
}


static hostState emptyState(const domain& d, double rho0)
{
    hostState s;
    s.dimensions = d.dimensions;
    s.h = d.spacing;
    s.rho0 = rho0;
    s.volume = d.volume;
    s.wallNames = d.walls;
    return s;
}


static std::vector<int> idsOf(const cloud& c, const fs::path& time)
{
    const std::vector<double>& ids =
        needField(c, "origId", "labelField", time).values;
    for (std::size_t i = 1; i < ids.size(); ++i)
    {
        if (!(ids[i] > ids[i - 1]))
        {
            throw userError
            (
                fmt::format("Id {} follows {}", ids[i], ids[i - 1]),
                {(time/"lagrangian"/c.name/"origId").string()},
                "Ids must ascend. Decompose the case again."
            );
        }
    }
    return {ids.begin(), ids.end()};
}


static void readFluid(hostState& s, cloud&& fluid, const fs::path& time)
{
    s.fluid = takeSet(fluid, s.rho0, time);
    s.fluid.mass = takeValues(fluid, "m", "scalarField", time);
    checkPositive(s.fluid.mass, "m", time/"lagrangian/fluid/m");
}


static void readWalls
(
    hostState& s,
    cloud&& walls,
    const fs::path& time,
    const domain& d
)
{
    s.walls = takeSet(walls, s.rho0, time);
    s.normals = vectorsOf(needField(walls, "normal", "vectorField", time));
    s.area = takeValues(walls, "area", "scalarField", time);
    const cloudField* reference = walls.find("referencePosition");
    s.wallReference = reference ? vectorsOf(*reference) : s.walls.positions;
    for (double p : needField(walls, "patch", "labelField", time).values)
    {
        if (p < 0 || p >= double(d.walls.size()))
        {
            throw userError
            (
                fmt::format
                (
                    "Patch {} is not one of the {} walls of constant/domain",
                    p, d.walls.size()
                ),
                {(time/"lagrangian/walls/patch").string()},
                "Time folder and constant/domain must come from the same "
                "seedParticles."
            );
        }
        s.patch.push_back(int(p));
    }
    if (!d.solids.empty())
    {
        s.wallNode = nodesOf(walls, s.solid.size(), time);
    }
}


hostState readState
(
    const fs::path& time,
    const domain& d,
    double rho0,
    bool anywhere
)
{
    hostState s = emptyState(d, rho0);
    s.solid = readSolidSet(time, d);
    if (!d.hasFluid())
    {
        return s;
    }
    readFluid(s, readCloud(time, "fluid", fluidRequest), time);
    if (!anywhere)
    {
        checkInside(s.fluid, d, time/"lagrangian/fluid/positions");
    }
    if (s.fluid.size() == 0)
    {
        throw userError
        (
            "There is no fluid particle",
            {(time/"lagrangian/fluid/positions").string()},
            "Seed the case with a smaller spacing."
        );
    }
    if (!d.walls.empty())
    {
        readWalls(s, readCloud(time, "walls"), time, d);
    }
    return s;
}


hostState readPart
(
    const fs::path& time,
    const fs::path& solidsTime,
    const domain& d,
    double rho0
)
{
    hostState s = emptyState(d, rho0);
    s.partial = true;
    s.solid = readSolidSet(solidsTime, d);
    if (!d.hasFluid())
    {
        return s;
    }
    cloud fluid = readCloud(time, "fluid", fluidRequest);
    s.fluidId = idsOf(fluid, time);
    readFluid(s, std::move(fluid), time);
    checkInside(s.fluid, d, time/"lagrangian/fluid/positions");
    if (!d.walls.empty())
    {
        cloud walls = readCloud(time, "walls");
        s.wallId = idsOf(walls, time);
        readWalls(s, std::move(walls), time, d);
    }
    return s;
}


static cloudView toCloud(const char* name, const particleSet& s, double rho0)
{
    cloudView c(name, s.positions);
    c.addVector("U", s.U);
    std::vector<double> rho;
    rho.reserve(s.size());
    for (const double d : s.deltaRho)
    {
        rho.push_back(d + rho0);
    }
    c.hold("scalarField", "rho", std::move(rho));
    c.addScalar("deltaRho", s.deltaRho);
    return c;
}


static void addLabels
(
    cloudView& c,
    const char* name,
    const std::vector<int>& labels
)
{
    c.hold("labelField", name, {labels.begin(), labels.end()});
}


static std::vector<double> pressures
(
    const hostState& s,
    const std::function<double(double)>& pressure
)
{
    std::vector<double> p;
    p.reserve(s.fluid.size());
    for (const double d : s.fluid.deltaRho)
    {
        p.push_back(pressure(s.rho0 + d));
    }
    return p;
}


std::size_t writeState
(
    const fs::path& time,
    const hostState& s,
    const std::function<double(double)>& pressure,
    const writeOptions& options
)
{
    std::size_t bytes = writeSolidSet(time, s.solid, s.partial, options);
    const bool noFluid = s.partial ? s.volume == 0 : s.fluid.size() == 0;
    if (noFluid)
    {
        return bytes;
    }
    {
        cloudView fluid = toCloud("fluid", s.fluid, s.rho0);
        fluid.addScalar("m", s.fluid.mass);
        fluid.hold("scalarField", "p", pressures(s, pressure));
        if (s.partial)
        {
            addLabels(fluid, "origId", s.fluidId);
        }
        bytes += writeCloud(time, fluid, options);
    }
    if (!s.wallNames.empty())
    {
        cloudView walls = toCloud("walls", s.walls, s.rho0);
        walls.addVector("normal", s.normals);
        walls.addScalar("area", s.area);
        walls.addVector("referencePosition", s.wallReference);
        addLabels(walls, "patch", s.patch);
        if (!s.solid.names.empty() || !s.wallNode.empty())
        {
            addLabels(walls, "node", s.wallNode);
        }
        if (s.partial)
        {
            addLabels(walls, "origId", s.wallId);
        }
        bytes += writeCloud(time, walls, options);
    }
    return bytes;
}

} // namespace gpuFsi
