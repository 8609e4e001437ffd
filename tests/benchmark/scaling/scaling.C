// A thousand steps on a periodic lattice seeded in memory, on the ranks that
// mpirun started or on one: time, what travels, and a fingerprint of the result.
// Usage: mpirun -np N scaling -parallel [-backend B] [-precision P] [-n N]
//            [-boxes '(a b c)'] [-steps S] [-refresh STEPS] [-scheme WORD]
//            [-method WORD] [-cuts '(x y z)'] [-displace SHARE] [-staged]

#include "base/log.H"
#include "benchmark/schemeWords.H"
#include "case/argList.H"
#include "common/lattice.H"
#include "decomposition/decomposition.H"
#include "parallel/parallelMain.H"
#include "stepping/fluidSolver.H"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <sstream>

using namespace gpuFsi;

static double now()
{
    const auto t = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(t).count();
}

static argList arguments(int argc, char** argv)
{
    return argList
    (
        argc, argv, "Measure steps on many ranks.",
        {
            {"parallel", "", "ranks of mpirun"},
            {"backend", "cpu|cuda|auto", "where to run"},
            {"precision", "single|double", "of the particles"},
            {"n", "N", "particles along a side of a box"},
            {"boxes", "'A B C'", "such boxes along x, y, z"},
            {"steps", "S", "steps in each of three measurements"},
            {"displace", "SHARE", "random displacement in spacings"},
            {"refresh", "STEPS", "refresh neighbours every so many steps"},
            {"scheme", "WORD", "as stepRate's"},
            {"method", "WORD", "simple (default), hilbert, scotch"},
            {"cuts", "'X Y Z'", "of method simple"},
            {"staged", "", "all values as messages from the host's memory"}
        },
        false
    );
}

static std::array<int, 3> three(const std::string& text)
{
    std::array<int, 3> v{1, 1, 1};
    std::istringstream(text) >> v[0] >> v[1] >> v[2];
    return v;
}

static domain boxes(int n, const std::array<int, 3>& times)
{
    domain d = periodicBox(n, 3, 15);
    const double side = 15;
    d.lo = {0, 0, 0};
    d.hi = {side*times[0], side*times[1], side*times[2]};
    d.volume = d.hi.x*d.hi.y*d.hi.z;
    return d;
}

static rankSettings settings(const argList& args, const communicator& ranks)
{
    const std::string method = args.getOrDefault("method", "simple");
    const std::string slabs = fmt::format("{} 1 1", ranks.size());
    const dictionary dict = dictionary::fromString
    (
        fmt::format
        (
            "numberOfSubdomains {}; method {}; simpleCoeffs {{ n ({}); }}",
            ranks.size(), method, args.getOrDefault("cuts", slabs)
        ),
        "arguments"
    );
    const std::shared_ptr<const decomposition> shares =
        decomposition::make(dict, ".");
    rankSettings s;
    s.method = method;
    s.peers = !args.found("staged");
    s.direct = ranks.takesDeviceMemory() && s.peers;
    s.assign = [shares, n = ranks.size()]
    (
        const blockGrid& grid,
        const std::vector<double>& weight
    )
    {
        return shares->assign(grid, weight, n);
    };
    return s;
}

//- Of places, velocities and densities, whatever the ranks
static std::uint64_t fingerprint(const hostState& s, const communicator& ranks)
{
    const auto bits = [](double v)
    {
        std::uint64_t b;
        std::memcpy(&b, &v, sizeof b);
        return b;
    };
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        const vector& u = s.fluid.U[i];
        std::uint64_t h = s.partial ? s.fluidId[i] : i;
        for (double v : {x.x, x.y, x.z, u.x, u.y, u.z, s.fluid.deltaRho[i]})
        {
            h = (h ^ bits(v))*0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        sum += h;
    }
    std::int64_t all = std::int64_t(sum);
    ranks.sum(&all, 1);
    return std::uint64_t(all);
}

static int measure(const communicator& ranks, int argc, char** argv)
{
    const argList args = arguments(argc, argv);
    const int n = std::stoi(args.getOrDefault("n", "64"));
    const int steps = std::stoi(args.getOrDefault("steps", "100"));
    const std::string precision = args.getOrDefault("precision", "single");
    const domain d = boxes(n, three(args.getOrDefault("boxes", "1 1 1")));
    fluidProperties fluid{};
    fluid.rho0 = 1;
    fluid.mu = 1;
    fluid.c = 1/std::sqrt(3.0);
    fluid.eos = fluidProperties::state::isothermal;
    particleSchemes schemes;
    schemes.searchRadius =
        d.spacing*particleSchemes::defaultSearchRadius(3);
    choose(args.getOrDefault("scheme", "radial"), 3, schemes);
    if (args.found("refresh"))
    {
        schemes.update = particleSchemes::trigger::interval;
        schemes.interval = std::stoi(args.get("refresh"));
    }
    std::unique_ptr<rankSetup> setup;
    if (ranks.size() > 1)
    {
        setup.reset(new rankSetup{ranks, settings(args, ranks)});
    }
    const double displace = std::stod(args.getOrDefault("displace", "0"));
    const auto solver = fluidSolver::make
    (
        args.getOrDefault("backend", "auto"), precision, d, fluid, schemes,
        latticeState(d, 0.01, 5, displace, ranks.rank(), ranks.size()),
        nullptr, setup.get()
    );

    const double dt = 0.2*d.spacing*d.spacing;
    double t = 0;
    std::vector<double> seconds;
    auto before = solver->stageSeconds();
    for (int round = 0; round < 4; ++round)
    {
        solver->monitor();
        ranks.barrier();
        const double begin = now();
        for (int s = 0; s < steps; ++s, t += dt)
        {
            solver->step(t, dt);
            if (solver->maintenanceDue())
            {
                solver->maintain();
            }
        }
        solver->monitor();
        ranks.barrier();
        if (round == 0)
        {
            before = solver->stageSeconds();
            continue;
        }
        seconds.push_back(now() - begin);
    }
    std::sort(seconds.begin(), seconds.end());
    const double perStep = seconds[1]/steps;
    const double count = double(solver->nFluid());
    const std::string shared =
        solver->describeRanks() + "; " + solver->describeMessages();
    const double bytes = double(solver->bytes());
    const std::uint64_t print = fingerprint(solver->download(), ranks);
    info("{} | {} | {} | ranks {} | {} particles | {:.4f} ms/step ({:.4f} to "
        "{:.4f}) | {:.1f} MIPPS | {:.1f} bytes/particle held | refreshes {} | "
        "fingerprint {:016x}",
        solver->device(), precision, args.getOrDefault("scheme", "radial"),
        ranks.size(), solver->nFluid(), 1e3*perStep, 1e3*seconds[0]/steps,
        1e3*seconds[2]/steps, count/perStep/1e6, bytes/count,
        solver->nRefreshes(), print);
    if (setup)
    {
        info("    {}", shared);
    }
    const auto stages = solver->stageSeconds();
    for (std::size_t s = 0; s < stages.size(); ++s)
    {
        info("    {:<12}{:.4g} ms/step", stageNames[s],
            1e3*(stages[s] - before[s])/(3*steps));
    }
    return 0;
}

int main(int argc, char** argv)
{
    return runParallelMain("scaling", argc, argv, [&](const communicator& r)
    {
        return measure(r, argc, argv);
    });
}
