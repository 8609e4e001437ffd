// Compressible isothermal fluid on Lagrangian particles without kernels, and
// elastic solids as damped springs.
//
// Usage: gpuFsiFoam [-case DIR] [-noFunctionObjects]
// Reads  constant/{domain,fluidProperties[,g][,wallProperties]}, with elastic
//        solids constant/{solid,solidProperties[,couplingProperties]},
//        system/{controlDict,particleSchemes}, the start time's clouds.

#include "base/log.H"
#include "case/argList.H"
#include "case/Time.H"
#include "functionObjects/functionObjectList.H"
#include "particles/stateIO.H"
#include "runControls.H"
#include "runReport.H"
#include "runSteps.H"

using namespace gpuFsi;

static int solve(int argc, char** argv)
{
    const argList args
    (
        argc, argv,
        "Solve the flow of a seeded case.",
        {{"noFunctionObjects", "", "leave out controlDict's functions"}}
    );
    printBanner(args.commandLine(), args.casePath().string());

    info("Create time\n");
    Time runTime(args.casePath());
    const runControls controls(runTime.controlDict());
    const domain space = domain::read(args.casePath());
    const fluidProperties fluid =
        fluidProperties::read(args.casePath(), space);
    const particleSchemes schemes =
        particleSchemes::read(args.casePath(), space);
    const std::unique_ptr<solidScene> solids =
        solidScene::read(args.casePath(), space);
    hostState initial = readState(runTime.startPath(), space, fluid.rho0);
    initial.time = runTime.value();

    const std::unique_ptr<fluidSolver> solver = fluidSolver::make
    (
        controls.backend, controls.precision, space, fluid, schemes,
        std::move(initial), solids.get()
    );
    runReport report(runTime, space, fluid, schemes, *solver);
    functionObjectList functions
    (
        runTime.controlDict(), report.info(),
        !args.found("noFunctionObjects")
    );
    runTime.controlDict().warnUnread();
    report.printScene();

    info("Starting time loop\n");
    runSteps(runTime, controls, fluid, *solver, functions, report);

    report.printEnd();
    info("End\n");
    return 0;
}

int main(int argc, char** argv)
{
    return runMain("gpuFsiFoam", [&] { return solve(argc, argv); });
}
