#include "scratch.H"
#include "study/commandRun.H"

#include <csignal>
#include <cstdlib>

#include <sys/resource.h>
#include <sys/wait.h>

using namespace gpuFsi;

namespace
{

//- Number of the processes still there whose ids these files hold
int nAlive(const scratch& s, const std::vector<std::string>& files)
{
    int n = 0;
    for (const std::string& file : files)
    {
        std::ifstream stream(s.path/file);
        pid_t id = 0;
        EXPECT_TRUE(stream >> id) << file;
        n += id > 0 && kill(id, 0) == 0;
    }
    return n;
}


commandOutcome ran
(
    const scratch& s,
    const std::vector<std::string>& commands,
    double timeLimit
)
{
    return runCommands(s.path, commands, {}, s.path/"log", timeLimit);
}

//- A sleeper in a session of its own, its id in a file
const char* const sleeper =
    "setsid bash -c 'echo $$ > apart; exec sleep 100' & "
    "until [ -s apart ]; do sleep 0.01; done";

} // namespace


TEST(runCommands, timeLimitEndsWhatHasAGroupOfItsOwn)
{
    const scratch s;
    const commandOutcome o =
        ran(s, {"echo $$ > shell", sleeper, "sleep 100"}, 0.5);
    EXPECT_TRUE(o.timedOut);
    EXPECT_FALSE(o.good());
    EXPECT_LT(o.seconds, 5);
    EXPECT_EQ(nAlive(s, {"shell", "apart"}), 0);
}


TEST(runCommands, nothingOutlivesThem)
{
    const scratch s;
    const commandOutcome o = ran(s, {sleeper}, 100);
    EXPECT_TRUE(o.good());
    EXPECT_EQ(nAlive(s, {"apart"}), 0);
}


TEST(runCommands, endBeforeTheProgramThatASignalEnds)
{
    for (const int number : {SIGHUP, SIGQUIT, SIGTERM, SIGINT})
    {
        const scratch s;
        const pid_t id = fork();
        if (id == 0)
        {
            const rlimit noCore{0, 0};
            setrlimit(RLIMIT_CORE, &noCore);
            signal(number, SIG_DFL);
            ran(s, {sleeper, "touch ready", "sleep 100"}, 100);
            _exit(9);
        }
        for (int i = 0; i < 1000 && !std::filesystem::exists(s.path/"ready");
            ++i)
        {
            usleep(10000);
        }
        kill(id, number);
        int status = 0;
        waitpid(id, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status)) << number;
        EXPECT_EQ(WTERMSIG(status), number);
        EXPECT_EQ(nAlive(s, {"apart"}), 0);
    }
}


TEST(runCommands, othersAreLeftAlone)
{
    const pid_t id = fork();
    if (id == 0)
    {
        execlp("sleep", "sleep", "100", static_cast<char*>(nullptr));
        _exit(127);
    }
    const scratch s;
    EXPECT_EQ(ran(s, {"exit 3"}, 100).code, 3);
    EXPECT_EQ(kill(id, 0), 0);
    kill(id, SIGKILL);
    waitpid(id, nullptr, 0);
}


TEST(runCommands, timeLimitEndsRanks)
{
    const scratch s;
    if (std::system("command -v mpirun > /dev/null") != 0)
    {
        GTEST_SKIP() << "no mpirun";
    }
    const commandOutcome o = runCommands
    (
        s.path,
        {"mpirun -np 2 bash -c 'echo $$ > rank$OMPI_COMM_WORLD_RANK;"
            " exec sleep 100'"},
        {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
            "OMPI_MCA_rmaps_base_oversubscribe=1",
            "OMPI_MCA_hwloc_base_binding_policy=none"},
        s.path/"log", 8
    );
    EXPECT_TRUE(o.timedOut);
    EXPECT_EQ(nAlive(s, {"rank0", "rank1"}), 0);
}
