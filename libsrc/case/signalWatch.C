#include "case/signalWatch.H"

namespace gpuFsi
{

namespace
{

volatile std::sig_atomic_t writeAsked = 0;
volatile std::sig_atomic_t stopAsked = 0;

void askWrite(int)
{
    writeAsked = 1;
}

void askStop(int number)
{
    stopAsked = 1;
    if (number == SIGINT || number == SIGTERM)
    {
        std::signal(number, SIG_DFL);
    }
}

} // namespace

signalWatch::signalWatch(int writeNow, int stopAtWriteNow)
{
    writeAsked = 0;
    stopAsked = 0;
    install(SIGINT, askStop);
    install(SIGTERM, askStop);
    if (writeNow > 0)
    {
        install(writeNow, askWrite);
    }
    if (stopAtWriteNow > 0)
    {
        install(stopAtWriteNow, askStop);
    }
}

signalWatch::~signalWatch()
{
    for (auto old = former_.rbegin(); old != former_.rend(); ++old)
    {
        sigaction(old->number, &old->action, nullptr);
    }
}

void signalWatch::install(int number, void (*handler)(int))
{
    struct sigaction action{};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;    // a write under way goes on
    sigemptyset(&action.sa_mask);
    former old{number, {}};
    if (sigaction(number, &action, &old.action) == 0)
    {
        former_.push_back(old);
    }
}

bool signalWatch::takeWriteNow()
{
    const bool asked = writeAsked;
    writeAsked = 0;
    return asked;
}

bool signalWatch::takeStop()
{
    const bool asked = stopAsked;
    stopAsked = 0;
    return asked;
}

} // namespace gpuFsi
