#include "fixture.H"

using namespace gpuFsi;

struct faulty
{
    const char* text;
    int line;
    const char* says;
};


TEST(dictionaryErrors, nameTheLineAndTheRemedy)
{
    const faulty cases[] =
    {
        {"a 1;\ns\n{\n  b 1;\n", 3, "{ is not closed"},
        {"a\n(1 2\n;\n", 2, "( in the entry 'a' is not closed"},
        {"a 1;\nb (1 2", 2, "is not closed"},
        {"a 1;\nb \"text;\nc 1;", 2, "is not closed"},
        {"a 1;\n/* text", 2, "Comment /* is not closed"},
        {"a 1;\nb #{ text", 2, "#{ is not closed"},
        {"s\n{\n  a 1\n}\n", 3, "not ended by ';' before the }"},
        {"a 1\ns\n{\n}\n", 1, "not ended by ';' before the {"},
        {"a 1;\nb 2", 2, "the end of the file"},
        {"a 1;\n}\n", 2, "} closes nothing"},
        {"a 1;\n) b 1;\n", 2, "where a key or } belongs"},
        {"a 1;\n, b 1;\n", 2, "','"},
        {"a 1;\n5 b;\n", 2, "'5'"},
        {"a 1;\nb (1 2];\n", 2, "meets the ("},
        {"a 1;\nb 1);\n", 2, "closes nothing"},
        {"a 1;\nb $c;\n", 2, "$c names nothing"},
        {"alpha 1;\nb $alpah;\n", 2, "Is $alpha meant?"},
        {"\nx $x;\n", 2, "given by itself"},
        {"s\n{\n  $s;\n}\n", 3, "inside the dictionary that it names"},
        {"s { a 1; }\nb (1 $s);\n", 2, "midst of a value"},
        {"a 1;\n$a;\n", 2, "where a dictionary belongs"},
        {"\nb $;\n", 2, "$ stands alone"},
        {"\nb ${x;\n", 2, "is not closed"},
        {"\n#inclued \"x\"\n", 2, "did you mean #include?"},
        {"\n#codeStream { }\n", 2, "code in a dictionary is not run"},
        {"\na #codeStream { };\n", 2, "Code is not compiled"},
        {"\na #eval 1;\n", 2, "not followed by an expression"},
        {"\na #eval{ 1;\n", 2, "is not closed"},
        {"\na #eval{ 1/0 };\n", 2, "division by zero"},
        {"\na 'b';\n", 2, "double quotes"},
        {"\na f(x y);\n", 2, "unclosed parenthesis"},
        {"\na \x01;\n", 2, "code 1 is not text"},
        {"a 1\n#include \"x\"\nb 2;", 2, "\"x\" is not found"},
        {"\na b/c;\n", 2, "A path stands in quotes"},
        {"\na = 5;\n", 2, "A stray ="},
        {"\na (1, 2 , 3);\n", 2, "A stray ,"},
    };
    for (const faulty& c : cases)
    {
        std::string message;
        int line = 0;
        try
        {
            parse(c.text);
        }
        catch (const userError& e)
        {
            message = e.what();
            line = e.where().first;
            EXPECT_EQ(e.where().file, "system/controlDict") << c.text;
        }
        EXPECT_SAYS(message, c.says) << "\nof: " << c.text;
        EXPECT_EQ(line, c.line) << message << "\nof: " << c.text;
    }
}


TEST(dictionaryErrors, missingEntryNamesTheNearest)
{
    const dictionary d = parse("\ndeltat 1;\ns\n{\n    a 1;\n}\n");
    const std::string missing =
        messageOf([&] { d.get<double>("deltaT"); });
    EXPECT_SAYS(missing,
        "Entry 'deltaT' not found in dictionary \"system/controlDict\"");
    EXPECT_SAYS(missing, "'deltat' at line 2 meant");
    EXPECT_SAYS(missing, "file: system/controlDict");
    const std::string inSub =
        messageOf([&] { d.subDict("s").get<double>("writeInterval"); });
    EXPECT_SAYS(inSub, "\"system/controlDict:s\"");
    EXPECT_SAYS(inSub, "keys there are: a");
    EXPECT_SAYS(inSub, "from line 3 to line 6.");
    EXPECT_SAYS(messageOf([&] { d.subDict("nn"); }), "sub-dictionary 'nn'");
    EXPECT_SAYS(messageOf([&] { d.subDict("deltat"); }),
        "a sub-dictionary was expected");
    EXPECT_SAYS(messageOf([&] { d.get<double>("s"); }),
        "is a sub-dictionary, a number was expected");
}


TEST(dictionaryErrors, forgottenSemicolonIsGuessed)
{
    const dictionary d = parse("deltaT 1e-3\nendTime 5;\n");
    const std::string message =
        messageOf([&] { d.get<double>("deltaT"); });
    EXPECT_SAYS(message, "'1e-3 endTime 5', a number was expected");
    EXPECT_SAYS(message, "';' missing at the end of line 1?");
}


TEST(dictionaryErrors, runawaysEnd)
{
    std::string bomb = "a0 (1 1);";
    for (int i = 1; i < 60; ++i)
    {
        const std::string before = " $a" + std::to_string(i - 1);
        bomb += "\na" + std::to_string(i) + " (" + before + before + ");";
    }
    EXPECT_SAYS(messageOf([&] { parse(bomb); }), "multiply each other");

    std::string dicts = "a0 { x 1; }";
    for (int i = 1; i < 60; ++i)
    {
        const std::string before = " $a" + std::to_string(i - 1);
        dicts += "\na" + std::to_string(i) + " { p" + before + "; q" + before
            + "; }";
    }
    EXPECT_SAYS(messageOf([&] { parse(dicts); }), "multiply each other");

    std::string deep;
    for (int i = 0; i < 100000; ++i)
    {
        deep += "a{";
    }
    EXPECT_SAYS(messageOf([&] { parse(deep); }), "nested more than");
}
