// Compressible isothermal fluid on Lagrangian particles without kernels, and
// elastic solids as damped springs.
//
// Usage: gpuFsiFoam [-case DIR] [-noFunctionObjects]
//        mpirun -np N gpuFsiFoam -parallel [...]    after decomposeParticles
// Reads  constant/{domain,fluidProperties[,g][,wallProperties]}, with elastic
//        solids constant/{solid,solidProperties[,couplingProperties]},
//        system/{controlDict,particleSchemes}, the start time's clouds.

#include "base/log.H"
#include "case/argList.H"
#include "functionObjects/functionObjectList.H"
#include "parallel/parallelMain.H"
#include "runReport.H"
#include "runSteps.H"
#include "scene.H"

using namespace gpuFsi;

static int solve(const communicator& ranks, int argc, char** argv)
{
    std::unique_ptr<argList> args;
    ranks.agree([&]
    {
        args = std::make_unique<argList>
        (
            argc, argv,
            "Solve the flow of a seeded case.",
            std::vector<argList::option>
            {
                {"parallel", "", "one rank of those that mpirun started"},
                {"noFunctionObjects", "", "leave out controlDict's functions"}
            }
        );
    });
    printBanner
    (
        args->commandLine(), args->casePath().string(), ranks.size()
    );

    info("Create time\n");
    const scene s(ranks, args->casePath());
    Time& runTime = *s.time;
    const std::unique_ptr<fluidSolver> solver = s.newSolver();
    runReport report
    (
        runTime, s.space, s.fluid, s.schemes, *solver, ranks.size()
    );
    functionObjectList functions
    (
        runTime.controlDict(), report.info(),
        !args->found("noFunctionObjects")
    );
    runTime.controlDict().warnUnread();
    report.printScene();

    info("Starting time loop\n");
    stepControl stepping(s, *solver, ranks);
    runSteps
    (
        runTime, *s.controls, stepping, s.fluid, *solver, functions, report,
        ranks
    );

    report.printEnd();
    info("End\n");
    return 0;
}

int main(int argc, char** argv)
{
    return runParallelMain("gpuFsiFoam", argc, argv, [&](const communicator& r)
    {
        return solve(r, argc, argv);
    });
}
