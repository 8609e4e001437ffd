// What a step costs: particle-steps a second, bytes moved by count and their
// share of what a plain copy reaches, bytes held, share of the neighbours'
// refresh. One scene, or with -table all of them.
// Usage: stepRate -help

#include "base/error.H"
#include "base/log.H"
#include "case/argList.H"
#include "device/useCuda.H"
#include "benchmark/step/copyRate.H"
#include "benchmark/step/countedBytes.H"
#include "benchmark/step/stepCost.H"
#include "benchmark/step/stepScene.H"

using namespace gpuFsi;

namespace
{

struct request
{
    std::string backend, precision;
    double displace;
    int refresh;           // steps; 0: where particles have moved
    int rounds, steps;
    bool inviscid;
    bool ratio;
    bool captured;         // the solids' launches as one, on a GPU?
    double copyRate;       // bytes/s
};

struct scene
{
    int D, n;
    std::string scheme;
    bool solid;
};

double copyRateOf(const std::string& backend)
{
#ifdef FSI_HAVE_CUDA
    if (useCuda(backend))
    {
        return copyRate<cudaBackend>();
    }
#endif
    useCuda(backend);    // complains where there is none
    return copyRate<cpuBackend>();
}

void printHead(const request& r)
{
    info
    (
        "A plain copy moves {:.4g} GB/s, read and written{}\n",
        1e-9*r.copyRate,
        r.ratio ? "; 'plain' is the processor time of a particle's step over "
                  "that of a plain loop in the same run" : ""
    );
    info
    (
        "| scene | scheme | particles | ms/step (range) | MIPPS | "
        "bytes/step by count | GB/s | of copy | bytes held | refresh, ms | "
        "refresh every 10 steps |{}",
        r.ratio ? " plain (range) |" : ""
    );
    info("|---|---|---|---|---|---|---|---|---|---|---|{}",
        r.ratio ? "---|" : "");
}

void printRow
(
    const scene& s,
    const fluidSolver& solver,
    const stepCost& cost,
    double bytes,
    double copyRate
)
{
    const double count = double(solver.nFluid()), step = cost.step();
    const double moved = count*bytes/step;
    const std::string plain = cost.ratio.empty() ? "" : fmt::format
    (
        " {:.3f} ({:.3f} to {:.3f}) |", median(cost.ratio),
        cost.ratio.front(), cost.ratio.back()
    );
    info
    (
        "| {}-D, fluid{} | {} | {} | {:.4g} ({:.4g} to {:.4g}) | {:.4g} | "
        "{:.0f} | {:.4g} | {:.1f}% | {:.1f} | {:.4g} | {:.1f}% |{}",
        s.D, s.solid ? " and solid" : "", s.scheme,
        solver.nFluid() + solver.nWalls() + solver.nSolid(), 1e3*step,
        1e3*cost.perStep.front(), 1e3*cost.perStep.back(), count/step/1e6,
        bytes, 1e-9*moved, 100*moved/copyRate,
        solver.bytes()/(count + solver.nWalls() + solver.nSolid()),
        1e3*cost.refresh, 100*cost.refresh/(cost.refresh + 10*step), plain
    );
    std::fflush(stdout);
}

std::unique_ptr<fluidSolver> run(const scene& s, const request& r)
{
    stepScene made(s.D, s.n, s.scheme, r.displace, s.solid);
    made.fluid.mu = r.inviscid ? 0 : made.fluid.mu;
    if (r.refresh > 0)
    {
        made.schemes.update = particleSchemes::trigger::interval;
        made.schemes.interval = r.refresh;
    }
    if (made.solids)
    {
        made.solids->properties.captured = r.captured;
    }
    auto solver = made.solver(r.backend, r.precision);
    std::unique_ptr<plainStep> plain;
    if (r.ratio)
    {
        plain = std::make_unique<plainStep>(s.D, s.n);
    }
    const stepCost cost =
        measure(*solver, made.deltaT(), r.rounds, r.steps, plain.get());
    printRow
    (
        s, *solver, cost,
        countedBytes(made.schemes, s.D, r.precision, useCuda(r.backend)),
        r.copyRate
    );
    return solver;
}

//- n: along a side in 3-D; as many in 2-D
void runAll(int n, const request& r)
{
    printHead(r);
    for (const int D : {2, 3})
    {
        const int side = D == 3 ? n : int(std::lround(std::pow(n, 1.5)));
        for (const char* scheme : {"radial", "moment", "full"})
        {
            for (const bool solid : {false, true})
            {
                run({D, side, scheme, solid}, r);
            }
        }
    }
}

void runOne(const scene& s, const request& r)
{
    printHead(r);
    const auto solver = run(s, r);
    info("\n{}, {} precision; {} refreshes; {} steps of solids as one launch; "
        "seconds by stage:", solver->device(), r.precision,
        solver->nRefreshes(), solver->nReplays());
    const auto stages = solver->stageSeconds();
    for (std::size_t k = 0; k < stages.size(); ++k)
    {
        info("    {:<12}{:.4g}", stageNames[k], stages[k]);
    }
}

int stepRate(int argc, char** argv)
{
    const argList args
    (
        argc, argv, "Measure what a step costs.",
        {
            {"backend", "cpu|cuda|auto", "where to run"},
            {"precision", "single|double", "of the particles"},
            {"dimensions", "2|3", "of the lattice"},
            {"n", "N", "particles along a side (-table: in 3-D; as many in 2-D)"},
            {"steps", "S", "steps in each measurement"},
            {"rounds", "R", "measurements, of which the median is told"},
            {"displace", "SHARE", "random displacement in spacings"},
            {"refresh", "STEPS", "refresh neighbours every so many steps"},
            {"scheme", "WORD", "radial (default), moment, hermite, full, fullSymplectic"},
            {"inviscid", "", "a fluid without viscosity"},
            {"solid", "", "an elastic block in the fluid"},
            {"loops", "", "launch the solids' loops one by one (backend cuda)"},
            {"table", "", "2-D, 3-D; radial, moment, full; without and with solid"},
            {"ratio", "", "beside a plain loop in the same run (backend cpu)"}
        },
        false
    );
    const auto number = [&](const char* name, const char* otherwise)
    {
        return std::stoi(args.getOrDefault(name, otherwise));
    };
    request r;
    r.backend = args.getOrDefault("backend", "auto");
    r.precision = args.getOrDefault("precision", "single");
    r.displace = std::stod(args.getOrDefault("displace", "0"));
    r.refresh = number("refresh", "0");
    r.rounds = number("rounds", "3");
    r.steps = number("steps", "100");
    r.inviscid = args.found("inviscid");
    r.ratio = args.found("ratio");
    r.captured = !args.found("loops");
    if (r.ratio && useCuda(r.backend))
    {
        throw userError
        (
            "-ratio compares processor times, but the backend is cuda", {},
            "Add -backend cpu."
        );
    }
    r.copyRate = copyRateOf(r.backend);
    const int n = number("n", "64");
    if (args.found("table"))
    {
        runAll(n, r);
        return 0;
    }
    runOne
    (
        {
            number("dimensions", "3"), n,
            args.getOrDefault("scheme", "radial"), args.found("solid")
        },
        r
    );
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return runMain("stepRate", [&] { return stepRate(argc, argv); });
}
