#include "process.H"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{

void sendTo(int descriptor, const fs::path& file)
{
    const int to = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(to, descriptor);
    close(to);
}

} // namespace


process::process
(
    const std::vector<std::string>& words,
    const fs::path& scratch,
    const std::vector<std::string>& environment
)
:
    out_(scratch.string() + ".out"),
    err_(scratch.string() + ".err")
{
    std::vector<char*> arguments;
    for (const std::string& word : words)
    {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ == 0)
    {
        for (const std::string& setting : environment)
        {
            putenv(const_cast<char*>(setting.c_str()));
        }
        sendTo(1, out_);
        sendTo(2, err_);
        if (chdir(scratch.c_str()) == 0)
        {
            execvp(arguments[0], arguments.data());
        }
        _exit(127);
    }
}


process::~process()
{
    if (!ended_)
    {
        kill(id_, SIGKILL);
        waitpid(id_, &status_, 0);
    }
}


bool process::poll()
{
    ended_ = ended_ || waitpid(id_, &status_, WNOHANG) == id_;
    return ended_;
}


bool process::running()
{
    return !poll();
}


void process::signal(int number)
{
    if (running())
    {
        kill(id_, number);
    }
}


std::string process::output() const
{
    return bytesOf(out_);
}


outcome process::wait(double seconds)
{
    using clock = std::chrono::steady_clock;
    const auto limit = clock::now() + std::chrono::duration<double>(seconds);
    bool tooLong = false;
    while (!poll())
    {
        if (clock::now() > limit && !tooLong)
        {
            tooLong = true;
            kill(id_, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    outcome o;
    o.code = tooLong ? 124
        : WIFSIGNALED(status_) ? 128 + WTERMSIG(status_)
        : WEXITSTATUS(status_);
    o.out = bytesOf(out_);
    o.err = bytesOf(err_);
    return o;
}


std::string bytesOf(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}


outcome run
(
    const std::vector<std::string>& words,
    const fs::path& scratch,
    const std::vector<std::string>& environment
)
{
    return process(words, scratch, environment).wait();
}


outcome shell(const std::string& command, const fs::path& scratch)
{
    return run({"bash", "-c", command}, scratch);
}
