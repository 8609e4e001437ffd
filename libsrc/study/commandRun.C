#include "study/commandRun.H"

#include "base/error.H"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

volatile sig_atomic_t child = 0;

//- The commands have a process group of their own, which ends with us
extern "C" void endWithChild(int number)
{
    if (child)
    {
        kill(-child, SIGTERM);
    }
    signal(number, SIG_DFL);
    raise(number);
}

//- Handlers while commands run
class signalGuard
{
public:

    signalGuard()
    :
        interrupt_(signal(SIGINT, endWithChild)),
        terminate_(signal(SIGTERM, endWithChild))
    {}

    ~signalGuard()
    {
        child = 0;
        signal(SIGINT, interrupt_);
        signal(SIGTERM, terminate_);
    }

private:

    sighandler_t interrupt_, terminate_;
};


void setEnvironment(const std::vector<std::string>& environment)
{
    for (const std::string& setting : environment)
    {
        const std::size_t at = setting.find('=');
        setenv
        (
            setting.substr(0, at).c_str(), setting.substr(at + 1).c_str(), 1
        );
    }
    std::error_code code;
    const fs::path self = fs::read_symlink("/proc/self/exe", code);
    const char* path = getenv("PATH");
    if (!code)
    {
        const std::string all =
            self.parent_path().string() + (path ? std::string(":") + path : "");
        setenv("PATH", all.c_str(), 1);
    }
}


[[noreturn]] void become
(
    const fs::path& directory,
    const std::string& script,
    const std::vector<std::string>& environment,
    const fs::path& log
)
{
    setpgid(0, 0);
    setEnvironment(environment);
    const int out =
        open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    const int in = open("/dev/null", O_RDONLY);
    if (out >= 0 && in >= 0 && chdir(directory.c_str()) == 0
     && dup2(in, 0) >= 0 && dup2(out, 1) >= 0 && dup2(out, 2) >= 0)
    {
        execlp
        (
            "bash", "bash", "-e", "-o", "pipefail", "-c", script.c_str(),
            static_cast<char*>(nullptr)
        );
    }
    _exit(127);
}


int exitCode(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace


commandOutcome runCommands
(
    const fs::path& directory,
    const std::vector<std::string>& commands,
    const std::vector<std::string>& environment,
    const fs::path& log,
    double timeLimit
)
{
    using clock = std::chrono::steady_clock;
    std::string script;
    for (const std::string& command : commands)
    {
        script += command + '\n';
    }
    const signalGuard guard;
    const auto begin = clock::now();
    const pid_t id = fork();
    if (id < 0)
    {
        throw userError
        (
            std::string("Cannot start bash: ") + std::strerror(errno)
        );
    }
    if (id == 0)
    {
        become(directory, script, environment, log);
    }
    child = id;
    commandOutcome result;
    const auto seconds = [&]
    {
        return std::chrono::duration<double>(clock::now() - begin).count();
    };
    int status = 0;
    while (waitpid(id, &status, WNOHANG) == 0)
    {
        if (seconds() > timeLimit)
        {
            result.timedOut = true;
            kill(-id, SIGKILL);
            waitpid(id, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    result.seconds = seconds();
    result.code = exitCode(status);
    return result;
}

} // namespace gpuFsi
