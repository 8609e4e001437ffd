#include "breakage.H"

#include <gtest/gtest.h>

#include <cstdlib>

damage set(const char* file, const char* key, const char* value)
{
    return [=](systemCase& c) { c.set(file, key, value); };
}


damage add(const char* file, const char* line)
{
    return [=](systemCase& c) { c.add(file, line); };
}


damage erase(const char* file, const char* key)
{
    return [=](systemCase& c) { c.erase(file, key); };
}


damage replace(const char* file, const char* from, const char* to)
{
    return [=](systemCase& c) { c.replace(file, from, to); };
}


damage overwrite(const char* file, const std::string& bytes)
{
    return [=](systemCase& c) { c.write(file, bytes); };
}


damage drop(const char* file)
{
    return [=](systemCase& c) { c.remove(file); };
}


damage nothing()
{
    return [](systemCase&) {};
}


damage unplaced(const damage& change)
{
    return [=](systemCase& c)
    {
        change(c);
        c.write(c.editedFile(), c.text(c.editedFile()));
    };
}


const systemCase& soundCase()
{
    static const systemCase sound = []
    {
        systemCase c = systemCase::pulse();
        c.seed();
        c.set("system/controlDict", "endTime", "0.2");
        const outcome o = c.run(app::gpuFsiFoam);
        EXPECT_EQ(o.code, 0) << o.out << o.err;
        c.set("system/controlDict", "endTime", "0.4");
        return c;
    }();
    return sound;
}


//- "at line 12." or "from line 12 to line 19." holds the line, or the next:
//  a change may start with the end of a line
static bool namesLine(const std::string& message, int line)
{
    const std::size_t last = message.rfind(" line ");
    if (last == std::string::npos)
    {
        return false;
    }
    const int high = std::atoi(message.c_str() + last + 6);
    const std::size_t from = message.rfind(" from line ", last);
    const int low = from == std::string::npos
        ? high : std::atoi(message.c_str() + from + 11);
    return low <= line + 1 && line <= high;
}


//- What was there before, and what is new but for results of particlesToVTK,
//  which writes time after time
static fileTree kept(const fileTree& all, const fileTree& before)
{
    fileTree files;
    for (const auto& [name, bytes] : all)
    {
        if (before.count(name) || name.compare(0, 3, "VTK") != 0)
        {
            files[name] = bytes;
        }
    }
    return files;
}


void expectRefused(const breakage& b)
{
    systemCase c(soundCase());
    b.change(c);
    const fileTree before = c.tree();
    const outcome o =
        c.run(b.program, b.options, {"CUDA_VISIBLE_DEVICES="});

    SCOPED_TRACE(std::string(b.name) + ":\n" + o.err);
    EXPECT_EQ(o.code, 1);
    const std::size_t fatal = o.err.find("--> FOAM FATAL ");
    EXPECT_NE(fatal, std::string::npos);
    EXPECT_EQ(fatal, o.err.rfind("--> FOAM FATAL "));
    EXPECT_NE(o.err.find("FOAM exiting"), std::string::npos);
    EXPECT_NE(o.err.find(b.wrong), std::string::npos) << b.wrong;
    EXPECT_FALSE(b.remedy.empty());
    EXPECT_NE(o.err.find(b.remedy), std::string::npos) << b.remedy;
    EXPECT_EQ(o.out.find("\nEnd"), std::string::npos);
    EXPECT_NE(o.err.find(c.editedFile()), std::string::npos)
        << c.editedFile();
    const bool data = c.editedFile().find("lagrangian") != std::string::npos;
    if (c.editedLine() > 0 && !data)
    {
        EXPECT_TRUE(namesLine(o.err, c.editedLine()))
            << "line " << c.editedLine();
    }
    EXPECT_EQ(difference(kept(c.tree(), before), before), "");
}
