#include "scratch.H"
#include "study/picture.H"
#include "study/report.H"

using namespace gpuFsi;

namespace
{

curvePoint point(const std::string& label, double error, double seconds)
{
    curvePoint p;
    p.resolution = label;
    p.error = error;
    p.seconds = {seconds, 0.9*seconds, 1.1*seconds};
    p.repeats = 3;
    p.run.device = "cpu, 1 thread";
    p.run.precision = "double";
    p.run.scheme = "a scheme";
    p.run.machine = "here";
    return p;
}

curve twoPoints()
{
    return
    {
        "it's one", false, {point("coarse", 0.1, 1), point("fine", 0.01, 9)}
    };
}

studyDict study()
{
    studyDict s;
    s.title = "a study";
    s.error.functionObject = "pulseError";
    s.error.norm = "relL2";
    s.targets = {0.1, 0.01, 0.001};
    s.parameters.resize(1);
    s.parameters[0].name = "h";
    return s;
}

} // namespace


TEST(report, tellsTimesToReachTheTargets)
{
    const std::string text = markdownOf(study(), {twoPoints()}, {}, {});
    expectIn("| it's one | at most 1 | 9 | not reached |", text);
    expectIn("| coarse |  | 0.1 |  | 1 | 0.9 to 1.1 |", text);
    expectIn("cpu, 1 thread, double precision, a scheme. Machine: here.", text);
    EXPECT_EQ(text.find("Compared"), text.npos);
    EXPECT_EQ(text.find("Failed"), text.npos);
}


TEST(report, saysWhereMachinesAreMixed)
{
    curve c = twoPoints();
    c.points[1].run.machine = "there";
    const std::string text = markdownOf(study(), {}, {c}, {"x: why\nand how"});
    expectIn("MACHINES MIXED: here; there.", text);
    expectIn("## Compared with", text);
    expectIn("- x: why\nand how", text);
}


TEST(report, namesWhatTheErrorIs)
{
    studyDict s = study();
    EXPECT_EQ(errorLabel(s), "pulseError, relL2");
    s.error = {};
    s.error.command = "x";
    s.error.finest = true;
    expectIn("its own finest run", errorLabel(s));
    s.error.label = "speed";
    EXPECT_EQ(errorLabel(s), "speed, difference from its own finest run");
}


TEST(picture, holdsDataMarksAndFront)
{
    curve own = twoPoints(), peer = twoPoints();
    own.points[0].pareto = true;
    peer.name = "peer";
    peer.compared = true;
    peer.points[1].resolution = "its own";
    const std::string text =
        gnuplotOf({own, peer}, "stem", "title", "x", "y", "h");
    expectIn("$front << EOD\n1 0.1 0.9 1.1 0\nEOD", text);
    expectIn("$iso1 << EOD\n9 0.01 8.1 9.9 0\nEOD", text);
    expectIn("title 'it''s one' noenhanced", text);
    expectIn("set output 'stem.svg'", text);
    // Marks: of the first and second resolution, and of one not the study's
    expectIn("$curve0 << EOD\n1 0.1 0.9 1.1 7\n9 0.01 8.1 9.9 5\nEOD", text);
    expectIn("$curve1 << EOD\n1 0.1 0.9 1.1 7\n9 0.01 8.1 9.9 2\nEOD", text);
}


//- A long name in the key takes the width from the picture
TEST(picture, aLoneCurveIsNotNamedTwice)
{
    curve own = twoPoints();
    own.name = "a long title";
    const std::string text =
        gnuplotOf({own}, "stem", own.name, "x", "y", "h");
    expectIn("set title 'a long title'", text);
    expectIn("title 'this study'", text);
}
