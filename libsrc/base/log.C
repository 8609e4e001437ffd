#include "base/log.H"

#include "base/version.H"

#include <ctime>
#include <unistd.h>

namespace gpuFsi
{

static bool silent = false;

void silenceLog(bool beSilent)
{
    silent = beSilent;
}


bool logIsSilent()
{
    return silent;
}


void warning(const std::string& text)
{
    if (silent)
    {
        return;
    }
    std::fflush(stdout);
    fmt::print(stderr, "--> FOAM Warning : {}\n", text);
}


void printBanner
(
    const std::string& commandLine,
    const std::string& casePath,
    int nProcs
)
{
    const std::time_t now = std::time(nullptr);
    const std::tm local = *std::localtime(&now);
    char date[64], clock[64], host[256] = "unknown";
    std::strftime(date, sizeof date, "%b %d %Y", &local);
    std::strftime(clock, sizeof clock, "%H:%M:%S", &local);
    gethostname(host, sizeof host - 1);

    info("gpuFsiFoam {}: particles for fluid-structure interaction",
        FSI_VERSION);
    info("Build  : {}", FSI_BUILD);
    info("Exec   : {}", commandLine);
    info("Date   : {}", date);
    info("Time   : {}", clock);
    info("Host   : {}", host);
    info("PID    : {}", getpid());
    info("Case   : {}", casePath);
    info("nProcs : {}", nProcs);
    info("// {} //", std::string(73, '*'));
    std::fflush(stdout);
}

} // namespace gpuFsi
