#include "fixture.H"

#include <random>

using namespace gpuFsi;

static const char* const seedText =
    "FoamFile { format ascii; class dictionary; object x; }\n"
    "// comment\na 1; b -2.5e-3; word div(phi,U); s \"a \\\"q\\\" b\";\n"
    "/* long */ list 3(1 2 3); all 2{0.5}; v ((0 0 0) (1 1 1));\n"
    "nu [0 2 -1 0 0 0 0] 1e-6; rho [kg m^-3] 1000; code #{ x; } #};\n"
    "sub { k 1; \"p.*\" 2; inner { x $a; y $..k; z $:b; } $inner; }\n"
    "sub { k 2; copy $sub.inner; } e #eval{ 2*$a + sqrt(4) };\n"
    "c #calc \"$b*2\"; #if #eval{ $a > 0 }\nq 1;\n#elif off\nq 2;\n#else\n"
    "q 3;\n#endif\n#ifeq $word linear\nr 1;\n#endif\n#inputMode protect\n"
    "a 5;\n#inputMode merge\n#remove (r \"q.*\")\n"
    "#includeIfPresent \"none\"\nf ${none:-3}; g $sub/k;\n";

static const char* const pieces[] =
{
    "{", "}", "(", ")", "[", "]", ";", "\"", "#{", "#}", "/*", "*/", "//",
    "$", "${", "$a", "$sub", "$..", "$:", "#if 1\n", "#else\n", "#endif\n",
    "#eval{", "#include \"x\"", "#remove ", "1e999", "-", "\\", "\n", "nan",
    "\0", "\xff", ",", "=", "3{", "a{", "$sub;", "#inputMode error\n"
};


//- Minimal standard generator and modulo: the same on every machine
class mutator
{
public:

    std::string next()
    {
        std::string text = seedText;
        for (std::size_t n = 1 + pick(4); n > 0; --n)
        {
            const std::size_t at = pick(text.size() + 1);
            const std::size_t length = pick(12);
            switch (pick(5))
            {
                case 0:
                    text.erase(at, length);
                    break;
                case 1:
                    text.insert(at, pieces[pick(std::size(pieces))]);
                    break;
                case 2:
                    text.insert(at, text.substr(pick(at + 1), 5*length));
                    break;
                case 3:
                    text.replace(at, 1, 1, char(pick(256)));
                    break;
                default:
                    text.resize(std::max<std::size_t>(at, 1));
            }
        }
        return text;
    }

private:

    std::minstd_rand random_{20240229};

    std::size_t pick(std::size_t n)
    {
        return (random_() >> 4) % n;
    }
};


static void visit(const dictionary& d)
{
    for (const std::string& key : d.keys())
    {
        if (d.isDict(key))
        {
            visit(d.subDict(key));
        }
        else if (d.found(key))
        {
            messageOf([&] { d.get<double>(key); });
            messageOf([&] { d.get<std::vector<vector>>(key); });
            messageOf([&] { d.getDimensioned(key, dimensions::length); });
        }
    }
    d.unread();
}


TEST(dictionaryFuzz, parsesOrTellsWhy)
{
    mutator mutants;
    int nParsed = 0, nRefused = 0;
    for (int i = 0; i < 10000; ++i)
    {
        const std::string text = mutants.next();
        try
        {
            const dictionary d = dictionary::fromString(text);
            visit(d);
            const std::string once = d.toText();
            ASSERT_EQ(dictionary::fromString(once).toText(), once)
                << "mutant " << i << ":\n" << text;
            ++nParsed;
        }
        catch (const userError& e)
        {
            ASSERT_FALSE(e.where().file.empty()) << e.what();
            ASSERT_GT(e.where().first, 0) << e.what();
            ++nRefused;
        }
        catch (const std::exception& e)
        {
            FAIL() << "mutant " << i << ": " << e.what() << "\n" << text;
        }
    }

    // Both outcomes are exercised
    EXPECT_GT(nParsed, 500);
    EXPECT_GT(nRefused, 500);
}
