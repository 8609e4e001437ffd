#include "study/commandRun.H"

#include "base/error.H"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

volatile sig_atomic_t asked = 0;

extern "C" void noteSignal(int number)
{
    asked = number;
}

//- While commands run: signals that end this program are noted, so that the
//  commands end before it; and what outlives its parent becomes our child
class processGuard
{
public:

    processGuard()
    {
        asked = 0;
        for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
        {
            const sighandler_t former = signal(number, noteSignal);
            if (former == SIG_IGN)
            {
                signal(number, SIG_IGN);    // nohup
            }
            former_.push_back({number, former});
        }
        prctl(PR_GET_CHILD_SUBREAPER, &reaper_);
        prctl(PR_SET_CHILD_SUBREAPER, 1);
    }

    ~processGuard()
    {
        prctl(PR_SET_CHILD_SUBREAPER, reaper_);
        for (const auto& [number, handler] : former_)
        {
            signal(number, handler);
        }
    }

private:

    std::vector<std::pair<int, sighandler_t>> former_;
    int reaper_ = 0;
};


using steadyClock = std::chrono::steady_clock;

double secondsSince(steadyClock::time_point begin)
{
    return std::chrono::duration<double>(steadyClock::now() - begin).count();
}


void waitABit()
{
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}


//- /proc/<id>/stat: id (name) state parent; the name may hold anything
pid_t parentOf(const fs::path& process)
{
    std::ifstream stream(process/"stat");
    // Iterators throw where the process has just ended; getline does not
    std::string text;
    std::getline(stream, text, '\0');
    const std::size_t name = text.rfind(')');
    return name == text.npos || name + 4 > text.size()
      ? 0 : std::atoi(text.c_str() + name + 4);
}


//- Of this program, those that have ended but are not waited for among them
std::vector<pid_t> children()
{
    std::vector<pid_t> all;
    std::error_code code;
    fs::directory_iterator it("/proc", code), end;
    for (; !code && it != end; it.increment(code))
    {
        const pid_t id = std::atoi(it->path().filename().c_str());
        if (id > 0 && parentOf(it->path()) == getpid())
        {
            all.push_back(id);
        }
    }
    return all;
}


bool holds(const std::vector<pid_t>& list, pid_t id)
{
    return std::find(list.begin(), list.end(), id) != list.end();
}


//- End all children but the former ones, and theirs as these fall to us.
//  SIGTERM first, once each: mpirun then ends its ranks, here and elsewhere.
void endChildren(const std::vector<pid_t>& former)
{
    for (const int number : {SIGTERM, SIGKILL})
    {
        std::vector<pid_t> told;
        const auto begin = steadyClock::now();
        while (secondsSince(begin) < 10)
        {
            bool any = false;
            for (const pid_t id : children())
            {
                if (holds(former, id))
                {
                    continue;
                }
                any = true;
                if (!holds(told, id))
                {
                    told.push_back(id);
                    kill(id, number);
                }
                waitpid(id, nullptr, WNOHANG);
            }
            if (!any)
            {
                return;
            }
            waitABit();
        }
    }
}


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
    // What a terminal sends goes to this program alone
    setpgid(0, 0);
    signal(SIGTERM, SIG_DFL);
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


pid_t start
(
    const fs::path& directory,
    const std::string& script,
    const std::vector<std::string>& environment,
    const fs::path& log
)
{
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
    return id;
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
    std::string script;
    for (const std::string& command : commands)
    {
        script += command + '\n';
    }
    commandOutcome result;
    {
        const processGuard guard;
        const std::vector<pid_t> former = children();
        const auto begin = steadyClock::now();
        int status = 0;
        const pid_t id = start(directory, script, environment, log);
        while (!asked && !result.timedOut && waitpid(id, &status, WNOHANG) == 0)
        {
            waitABit();
            result.timedOut = secondsSince(begin) > timeLimit;
        }
        result.seconds = secondsSince(begin);
        result.code = result.timedOut ? 128 + SIGTERM : exitCode(status);
        endChildren(former);
    }
    if (asked)
    {
        raise(asked);
        result.code = 128 + asked;
    }
    return result;
}

} // namespace gpuFsi
