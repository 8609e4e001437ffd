#include "fixture.H"

#include <cmath>

using namespace gpuFsi;

template<class T>
static std::string failure(const std::string& value)
{
    const dictionary d = parse("key " + value + ";");
    return messageOf([&] { d.get<T>("key"); });
}


TEST(dictionaryValues, numbers)
{
    const dictionary d = parse
    (
        "a 1; b -2.5e-3; c +.5; d 3.; e 1e6; f 9007199254740993; g -0;"
        "h [0 1 0 0 0 0 0] 4; i i [m] 5;"
    );
    EXPECT_EQ(d.get<int>("a"), 1);
    EXPECT_EQ(d.get<double>("b"), -2.5e-3);
    EXPECT_EQ(d.get<double>("c"), 0.5);
    EXPECT_EQ(d.get<double>("d"), 3);
    EXPECT_EQ(d.get<int>("e"), 1000000);
    EXPECT_EQ(d.get<long>("f"), 9007199254740993L);
    EXPECT_EQ(d.get<int>("g"), 0);
    EXPECT_EQ(d.get<double>("h"), 4);
    EXPECT_EQ(d.get<int>("i"), 5);
    EXPECT_EQ(d.getOrDefault<double>("none", 8), 8);
}


TEST(dictionaryValues, strictNumbers)
{
    EXPECT_EQ(parse("k 12abc;").get<std::string>("k"), "12abc");
    EXPECT_SAYS(failure<double>("12abc"), "the word '12abc'");
    EXPECT_SAYS(failure<double>("12abc"), "a number was expected");
    EXPECT_SAYS(failure<int>("1.5"), "the number '1.5'");
    EXPECT_SAYS(failure<int>("1.5"), "an integer was expected");
    EXPECT_SAYS(failure<int>("3000000000"), "an integer");
    EXPECT_SAYS(failure<long>("1e300"), "an integer");
    EXPECT_SAYS(failure<double>("nan"), "must be finite");
    EXPECT_SAYS(failure<double>("-inf"), "must be finite");
    EXPECT_SAYS(failure<double>("\"1\""), "the string '\"1\"'");
    EXPECT_SAYS(failure<double>("1 2"), "'1 2'");
    EXPECT_SAYS(failure<double>(""), "is empty");
    EXPECT_SAYS(messageOf([] { parse("k 1e400;"); }), "1e400");
    EXPECT_SAYS(messageOf([] { parse("k 1e-400;"); }), "double precision");
    for (const char* word : {"0x10", "1e", "1e+", "--1", "+-1", "1.2.3", "1,2",
        ".", "-", "infinity", "1d3"})
    {
        EXPECT_SAYS(failure<double>(word), "the word") << word;
    }
}


TEST(dictionaryValues, switches)
{
    for (const char* yes : {"true", "on", "yes", "y", "t", "1"})
    {
        EXPECT_TRUE(parse(std::string("k ") + yes + ";").get<bool>("k"));
    }
    for (const char* no : {"false", "off", "no", "n", "f", "0"})
    {
        EXPECT_FALSE(parse(std::string("k ") + no + ";").get<bool>("k"));
    }
    EXPECT_SAYS(failure<bool>("maybe"), "true on yes y t");
    EXPECT_SAYS(failure<bool>("2"), "a switch");
}


TEST(dictionaryValues, wordsAndStrings)
{
    const dictionary d = parse
    (
        "a div(phi,U); b \"x \\\"y\\\" z\"; c #{ two\nlines #}; d 12; e a.b-c;"
        "f \"one \\\ntwo\";"
    );
    EXPECT_EQ(d.get<std::string>("a"), "div(phi,U)");
    EXPECT_EQ(d.get<std::string>("b"), "x \"y\" z");
    EXPECT_EQ(d.get<std::string>("c"), " two\nlines ");
    EXPECT_EQ(d.get<std::string>("d"), "12");
    EXPECT_EQ(d.get<std::string>("e"), "a.b-c");
    EXPECT_EQ(d.get<std::string>("f"), "one two");
    EXPECT_SAYS(failure<std::string>("(a)"), "a word or string");
}


TEST(dictionaryValues, listsAndVectors)
{
    const dictionary d = parse
    (
        "v (1 -2 3e0); a 3(1 2 3); b (4 5); c 3{0.5}; e (); f 0(); g (a \"b\");"
        "h 2((0 0 0)(1 1 1)); i 2{(7 8 9)}; j (on off); k 0;"
    );
    const vector v = d.get<vector>("v");
    EXPECT_EQ(v.x, 1);
    EXPECT_EQ(v.y, -2);
    EXPECT_EQ(v.z, 3);
    EXPECT_EQ(d.get<std::vector<int>>("a"), (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(d.get<std::vector<double>>("b"), (std::vector<double>{4, 5}));
    EXPECT_EQ(d.get<std::vector<double>>("c"),
        (std::vector<double>{0.5, 0.5, 0.5}));
    EXPECT_TRUE(d.get<std::vector<long>>("e").empty());
    EXPECT_TRUE(d.get<std::vector<vector>>("f").empty());
    EXPECT_EQ(d.get<std::vector<std::string>>("g"),
        (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(d.get<std::vector<vector>>("h").size(), 2u);
    EXPECT_EQ(d.get<std::vector<vector>>("i")[1].z, 9);
    EXPECT_EQ(d.get<std::vector<bool>>("j"), (std::vector<bool>{true, false}));
    EXPECT_TRUE(d.get<std::vector<int>>("k").empty());
    EXPECT_SAYS(failure<vector>("(1 2)"), "a vector (x y z)");
    EXPECT_SAYS(failure<vector>("(1 2 3 4)"), "a vector (x y z)");
    EXPECT_SAYS(failure<vector>("1 2 3"), "a vector (x y z)");
    using integers = std::vector<int>;
    EXPECT_SAYS(failure<integers>("3(1 2)"), "each is an integer");
    EXPECT_SAYS(failure<integers>("(1 a)"), "a list");
    EXPECT_SAYS(failure<integers>("-1{2}"), "a list");
    EXPECT_SAYS(failure<integers>("7"), "a list");
}


TEST(dictionaryValues, dimensionsAreChecked)
{
    const dictionary d = parse
    (
        "a 1; b [0 2 -1 0 0 0 0] 2; c nu [0 2 -1 0 0] 3; d [m^2/s] 4;"
        "e [kinematicViscosity] 5; f [kg m^-3] 6; g [m s^-2] (0 0 -9.81);"
        "h [Pa s] 7; i [kg/(m s)] 8; j [] 9; k [0 2 -1 0] 1; l [ft] 1;"
        "m [kg m^] 1; n [kg*m*m/m^4] 10;"
    );
    using namespace dimensions;
    EXPECT_EQ(d.getDimensioned("a", kinematicViscosity), 1);
    EXPECT_EQ(d.getDimensioned("b", kinematicViscosity), 2);
    EXPECT_EQ(d.getDimensioned("c", kinematicViscosity), 3);
    EXPECT_EQ(d.getDimensioned("d", kinematicViscosity), 4);
    EXPECT_EQ(d.getDimensioned("e", kinematicViscosity), 5);
    EXPECT_EQ(d.getDimensioned("f", density), 6);
    EXPECT_EQ(d.getDimensionedVector("g", acceleration).z, -9.81);
    EXPECT_EQ(d.getDimensioned("h", dynamicViscosity), 7);
    EXPECT_EQ(d.getDimensioned("i", dynamicViscosity), 8);
    EXPECT_EQ(d.getDimensioned("j", none), 9);

    // kg m m / m^4 is kg m^-2: not a density
    const std::string wrong =
        messageOf([&] { d.getDimensioned("n", density); });
    EXPECT_SAYS(wrong, "expected [1 -3 0 0 0 0 0] = kg m^-3");
    EXPECT_SAYS(wrong, "found    [1 -2 0 0 0 0 0] = kg m^-2");
    EXPECT_SAYS(messageOf([&] { d.getDimensioned("k", none); }),
        "4 exponents");
    EXPECT_SAYS(messageOf([&] { d.getDimensioned("l", length); }),
        "unknown unit 'ft'");
    EXPECT_SAYS(messageOf([&] { d.getDimensioned("m", length); }),
        "number after ^");
}


TEST(dictionaryValues, rangesAndChoices)
{
    const dictionary d = parse("n 5;\nscheme lineer;");
    EXPECT_EQ(d.getNumber("n", 0, 5), 5);
    EXPECT_SAYS(messageOf([&] { d.getNumber("n", 0, 4); }), "from 0 to 4");
    EXPECT_SAYS(messageOf([&] { d.getNumber("n", 6, HUGE_VAL); }),
        "from 6 upwards");
    EXPECT_EQ(d.getNumberOrDefault("m", 3, 0, 1), 3);
    const std::string wrong =
        messageOf([&] { d.getChoice("scheme", {"linear", "cubic"}); });
    EXPECT_SAYS(wrong, "did you mean linear?");
    EXPECT_SAYS(wrong, "at line 2.");
    EXPECT_EQ(d.getChoice("scheme", {"lineer"}), "lineer");
    EXPECT_EQ(d.getChoiceOrDefault("none", "cubic", {"cubic"}), "cubic");
}
