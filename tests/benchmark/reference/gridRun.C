#include "gridRun.H"

#include "base/log.H"
#include "case/runClock.H"
#include "device/backend.H"
#include "particles/stateIO.H"

namespace gpuFsi
{

namespace fs = std::filesystem;

gridRun::settings gridRun::settings::read(const fs::path& casePath)
{
    const dictionary dict =
        dictionary::fromFile(casePath/"system/gridDict");
    settings s;
    s.scheme = dict.get<std::string>("scheme");
    s.schemeWhere = dict.where("scheme");
    s.n = int(dict.getNumber("n", 4, 2048));
    s.length = dict.getNumber("length", 1e-9, 1e9);
    s.rho = dict.get<std::string>("rho");
    s.rhoWhere = dict.where("rho");
    dict.warnUnread();
    return s;
}


static domain cubeOf(int n, double length)
{
    domain d;
    d.spacing = length/n;
    d.hi = vector{0.5*length, 0.5*length, 0.5*length};
    d.lo = -1.0*d.hi;
    d.periodic = {true, true, true};
    d.volume = length*length*length;
    return d;
}


gridRun::gridRun(const fs::path& casePath)
:
    settings_(settings::read(casePath)),
    space_(cubeOf(settings_.n, settings_.length)),
    fluid_(fluidProperties::read(casePath, space_)),
    state_(settings_.n, settings_.length),
    casePath_(casePath)
{
    if (fluid_.eos == fluidProperties::state::Tait)
    {
        throw userError
        (
            "The grid schemes take an isothermal or a linear fluid, but "
            "equationOfState is Tait",
            {(casePath/"constant/fluidProperties").string()},
            "Set type isothermal."
        );
    }
    fill(expression(settings_.rho, settings_.rhoWhere));
    writeStart();
    scheme_ = gridScheme::selection::make
    (
        "grid scheme", settings_.scheme, settings_.schemeWhere, state_,
        gridFluid{fluid_.rho0, fluid_.c, fluid_.mu}
    );
    info_.casePath = casePath;
    info_.startTime = time_->timeName();
    info_.rho0 = fluid_.rho0;
    info_.h = space_.spacing;
    info_.c = fluid_.c;
    info_.mu = fluid_.mu;
    info_.device = cpuBackend::describe();
    info_.precision = "double";
    info_.scheme = scheme_->describe();
    info_.pressure = [this](double rho) { return fluid_.pressure(rho); };
}


void gridRun::fill(const expression& rho)
{
    const int n = settings_.n;
    for (int k = 0; k < n; ++k)
    {
        for (int j = 0; j < n; ++j)
        {
            for (int i = 0; i < n; ++i)
            {
                state_.field(0)[state_.index(i, j, k)] =
                    rho(state_.position(i, j, k)) - fluid_.rho0;
            }
        }
    }
    state_.wrap();
}


//- As seedParticles leaves a case
void gridRun::writeStart()
{
    space_.write(casePath_);
    fs::remove_all(casePath_/"0");
    fs::create_directories(casePath_/"0");
    time_ = std::make_unique<Time>(casePath_);
    writeState
    (
        casePath_/"0", particles(),
        [this](double rho) { return fluid_.pressure(rho); }, time_->writing()
    );
}


hostState gridRun::particles() const
{
    hostState s;
    s.h = space_.spacing;
    s.rho0 = fluid_.rho0;
    s.volume = space_.volume;
    const double volume = s.h*s.h*s.h;
    const int n = settings_.n;
    for (int k = 0; k < n; ++k)
    {
        for (int j = 0; j < n; ++j)
        {
            for (int i = 0; i < n; ++i)
            {
                const long p = state_.index(i, j, k);
                const double delta = state_.field(0)[p];
                s.fluid.positions.push_back(state_.position(i, j, k));
                s.fluid.U.push_back
                ({
                    state_.field(1)[p], state_.field(2)[p], state_.field(3)[p]
                });
                s.fluid.deltaRho.push_back(delta);
                s.fluid.mass.push_back((s.rho0 + delta)*volume);
            }
        }
    }
    return s;
}


const runInfo& gridRun::info()
{
    info_.time = time_->value();
    info_.timeName = time_->timeName();
    info_.timeIndex = time_->index();
    info_.deltaT = time_->deltaT();
    info_.writeTime = time_->writeTime();
    info_.loopSeconds = loopSeconds_;
    info_.totalSeconds = time_->clockSeconds();
    const double n = settings_.n;
    info_.particleSteps = n*n*n*time_->index();
    return info_;
}


void gridRun::checkFinite() const
{
    if (!state_.finite())
    {
        throw userError
        (
            "The solution is not finite at Time = " + time_->timeName(),
            {(casePath_/"system/controlDict").string()},
            "Use a smaller deltaT."
        );
    }
}


void gridRun::run()
{
    gpuFsi::info("Grid        : {0} x {0} x {0} points, {1}", settings_.n,
        info_.scheme);
    functionObjectList functions(time_->controlDict(), info());
    functions.start(particles(), info());
    const runClock clock;
    while (time_->run())
    {
        ++*time_;
        const double begin = clock.wallSeconds();
        scheme_->step(state_, time_->deltaT());
        loopSeconds_ += clock.wallSeconds() - begin;
        const bool due = functions.due(info());
        if (due || time_->writeTime())
        {
            checkFinite();
        }
        if (due)
        {
            functions.execute(particles(), info());
        }
        if (time_->writeTime())
        {
            time_->write([this](const fs::path& directory)
            {
                writeState
                (
                    directory, particles(), info_.pressure, time_->writing()
                );
            });
        }
    }
    checkFinite();
    functions.end(info());
    gpuFsi::info("{}\n", time_->executionTime());
}

} // namespace gpuFsi
