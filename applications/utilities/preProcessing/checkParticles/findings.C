#include "findings.H"

#include "base/log.H"

void findings::good(const std::string& text)
{
    gpuFsi::info("    {} OK.", text);
}


void findings::bad(const std::string& text)
{
    ++failed_;
    gpuFsi::info(" ***{}", text);
}


void findings::printEnd() const
{
    if (failed_ == 0)
    {
        gpuFsi::info("\nParticles OK.\n");
    }
    else
    {
        gpuFsi::info
        (
            "\nFailed {} check{}.\n", failed_, failed_ == 1 ? "" : "s"
        );
    }
}
