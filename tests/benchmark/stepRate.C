// Particle-steps per second of the solver on a periodic lattice seeded in
// memory, with the bytes a step must move.
// Usage: stepRate [-backend B] [-precision P] [-dimensions D] [-n N]
//                 [-steps S] [-displace SHARE] [-refresh STEPS] [-scheme WORD]

#include "base/error.H"
#include "base/log.H"
#include "benchmark/schemeWords.H"
#include "case/argList.H"
#include "common/lattice.H"
#include "stepping/fluidSolver.H"

#include <chrono>

using namespace gpuFsi;

static double now()
{
    const auto t = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(t).count();
}

static int measure(int argc, char** argv)
{
    const argList args
    (
        argc, argv, "Measure particle-steps per second.",
        {
            {"backend", "cpu|cuda|auto", "where to run"},
            {"precision", "single|double", "of the particles"},
            {"dimensions", "2|3", "of the lattice"},
            {"n", "N", "particles along a side"},
            {"steps", "S", "steps in each of three measurements"},
            {"displace", "SHARE", "random displacement in spacings"},
            {"refresh", "STEPS", "refresh neighbours every so many steps"},
            {"scheme", "WORD", "radial (default), moment, hermite, full, fullSymplectic"}
        },
        false
    );
    const int D = std::stoi(args.getOrDefault("dimensions", "3"));
    const int n = std::stoi(args.getOrDefault("n", "64"));
    const int steps = std::stoi(args.getOrDefault("steps", "100"));
    const std::string precision = args.getOrDefault("precision", "single");

    const domain d = periodicBox(n, D, 15);
    fluidProperties fluid{};
    fluid.rho0 = 1;
    fluid.mu = 1;
    fluid.c = 1/std::sqrt(3.0);
    fluid.eos = fluidProperties::state::isothermal;
    particleSchemes schemes;
    schemes.searchRadius =
        d.spacing*particleSchemes::defaultSearchRadius(D);
    choose(args.getOrDefault("scheme", "radial"), D, schemes);
    if (args.found("refresh"))
    {
        schemes.update = particleSchemes::trigger::interval;
        schemes.interval = std::stoi(args.get("refresh"));
    }
    const double displace = std::stod(args.getOrDefault("displace", "0"));
    const auto solver = fluidSolver::make
    (
        args.getOrDefault("backend", "auto"), precision, d, fluid, schemes,
        latticeState(d, 0.01, 5, displace)
    );

    // Own state read and written, neighbour list read
    const double bytes = (precision == "single" ? 64 : 128)
        + 4*(D == 3 ? 26 : 8);
    const double dt = 0.2*d.spacing*d.spacing;
    double t = 0;
    std::vector<double> seconds;
    for (int round = 0; round < 4; ++round)
    {
        solver->maintain();
        const double begin = now();
        for (int s = 0; s < steps; ++s, t += dt)
        {
            solver->step(t, dt);
            if (solver->maintenanceDue())
            {
                solver->maintain();
            }
        }
        solver->maintain();
        if (round > 0)
        {
            seconds.push_back(now() - begin);
        }
    }
    std::sort(seconds.begin(), seconds.end());
    const double perStep = seconds[1]/steps;
    const double count = double(solver->nFluid());
    info("{} | {} | {}-D {} particles | {:.4f} ms/step ({:.4f} to {:.4f}) | "
        "{:.1f} MIPPS | {:.0f} bytes/particle moved by count, {:.3g} TB/s | "
        "{:.1f} bytes/particle held | refreshes {}",
        solver->device(), precision, D, solver->nFluid(),
        1e3*perStep, 1e3*seconds[0]/steps, 1e3*seconds[2]/steps,
        count/perStep/1e6, bytes, count*bytes/perStep/1e12,
        solver->bytes()/count, solver->nRefreshes());
    const auto stages = solver->stageSeconds();
    for (std::size_t s = 0; s < stages.size(); ++s)
    {
        info("    {:<12}{:.4g} s", stageNames[s], stages[s]);
    }
    return 0;
}

int main(int argc, char** argv)
{
    return runMain("stepRate", [&] { return measure(argc, argv); });
}
