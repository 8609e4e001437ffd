#include "breakage.H"

#include <gtest/gtest.h>

namespace
{

constexpr const char* file = "system/seedParticlesDict";
constexpr app seed = app::seedParticles;

const std::vector<breakage> dictionaries
{
    {"spacing missing", seed, erase(file, "spacing"),
        "Entry 'spacing' not found", "Add the entry 'spacing'"},
    {"spacing negative", seed, set(file, "spacing", "-1"),
        "spacing -1 is not a positive number", "metres"},
    {"spacing too large for a particle", seed,
        unplaced(set(file, "spacing", "40")), "No particle is inside",
        "that spacing is small enough"},
    {"spacing too small for any memory", seed, set(file, "spacing", "1e-9"),
        "spacing", "Increase spacing"},
    {"four dimensions", seed, add(file, "dimensions 4;"),
        "dimensions", "from 2 to 3"},
    {"two and a half dimensions", seed, add(file, "dimensions 2.5;"),
        "neither 2 nor 3", "x-y plane"},
    {"regions missing", seed, replace(file, "regions", "region"),
        "regions", "is 'region' at line 12 meant"},
    {"region not a dictionary", seed,
        replace(file, "regions\n{", "regions\n{ tank box;"),
        "Region tank is not a dictionary", "Write tank {"},
    {"region type", seed, set(file, "type", "cylindre"),
        "Unknown region type cylindre", "did you mean cylinder?"},
    {"radius missing", seed, erase(file, "radius"),
        "Entry 'radius' not found", "Add the entry 'radius'"},
    {"radius negative", seed, set(file, "radius", "-7.5"),
        "radius -7.5 is not a positive number", "metres"},
    {"cylinder without length", seed, set(file, "point2", "(0 -7.5 0)"),
        "point", "centres of its two end faces"},
    {"point of two numbers", seed, set(file, "point2", "(0 7.5)"),
        "point2", "(x y z)"},
    {"side", seed, set(file, "radius", "7.5; side outwards"),
        "outwards", "outside"},
    {"level set of unknown variable", seed,
        set(file, "type", "levelSet; expression \"x - a\""),
        "cannot be read at position", "Known are x y z r"},
    {"bounds missing", seed,
        unplaced(set(file, "type", "levelSet; expression \"r - 5\"")),
        "bounds are missing", "Give bounds"},
    {"bounds upside down", seed, add(file, "bounds ((9 9 9) (-9 -9 -9));"),
        "bounds", "first point of bounds is the lower"},
    {"bounds of one point", seed, add(file, "bounds ((9 9 9));"),
        "bounds has 1 points", "Give two"},
    {"periodic of two words", seed, add(file, "periodic (no yes);"),
        "periodic has 2 words", "Give three"},
    {"period not of whole spacings", seed,
        add(file, "bounds ((-9 -9.1 -9) (9 9.3 9)); periodic (no yes no);"),
        "periodic in y, but the length", "nearest spacing that fits is 0.92"},
    {"displacement over half", seed, add(file, "displace 2;"),
        "displace", "from 0 to 0.5"},
    {"field of unknown variable", seed, set(file, "rho", "\"1 + q\""),
        "cannot be read at position", "Known are x y z r"},
    {"field with a slip", seed, set(file, "rho", "\"1 + * 2\""),
        "cannot be read at position", "Known are x y z r"},
    {"field assigned", seed, set(file, "rho", "\"x = 2\""),
        "has an assignment", "Compare with =="},
    {"field infinite at a point", seed,
        set(file, "rho", "\"x > 0 ? 1 : 1/0\""), "is inf at the point",
        "Guard the singular point"},
    {"field not a number", seed, set(file, "rho", "\"sqrt(x)\""),
        "nan at the point", "Guard the singular point"},
    {"density negative", seed, set(file, "rho", "\"x\""), "rho", "positive"},
    {"velocity of two components", seed,
        replace(file, "fields\n{", "fields\n{ U (1 2);"),
        "Field U has 2 values", "three in parentheses"},
    {"field that is computed", seed,
        replace(file, "fields\n{", "fields\n{ m 1;"),
        "Field m cannot be given", "computes it"},
    {"points file missing", seed,
        set(file, "type", "points; file \"constant/scan.txt\""),
        "scan.txt", "relative to the case"},
    {"brace not closed", seed,
        unplaced(replace(file, "fields\n{", "fields\n")),
        "A } closes nothing", "add the { that it belongs to"},
    {"dictionary missing", seed, drop(file), "seedParticlesDict",
        "Does it exist"},
    {"dictionary empty", seed, overwrite(file, ""), "Entry",
        "the dictionary is empty"},
    {"controlDict broken", seed,
        set("system/controlDict", "writeFormat", "text"), "text", "binary"},
};

//- A solid, its entries in one line
damage solid(const std::string& entries, const std::string& others = "")
{
    const std::string line =
        "solids { beam { " + entries + " } " + others + " }";
    return [=](systemCase& c) { c.add(file, line); };
}

const std::string beam = "type box; min (0 0 0); max (5 2 2); ";

const std::vector<breakage> solids
{
    {"solid not a dictionary", seed, add(file, "solids { beam box; }"),
        "Solid beam is not a dictionary", "Write beam {"},
    {"solid of unknown type", seed, solid("type cylindre;"),
        "Unknown region type cylindre", "did you mean cylinder?"},
    {"solid of a plane", seed,
        solid("type plane; point (0 0 0); normal (0 0 1);"),
        "a plane encloses nothing", "Valid are box, sphere"},
    {"solid of points", seed, unplaced([](systemCase& c)
        {
            c.write("constant/scan.txt", "0 0 0 0 0 1\n");
            solid("type points; file \"constant/scan.txt\";")(c);
        }),
        "a points encloses nothing", "Valid are box, sphere"},
    {"solid with a side", seed, solid(beam + "side inside;"),
        "Solid beam has a side", "remove the entry"},
    {"solid of negative spacing", seed, solid(beam + "spacing -1;"),
        "spacing -1 is not a positive number", "in metres"},
    {"solid of too large a spacing", seed, solid(beam + "spacing 5;"),
        "spacing 5 is too large", "a smaller spacing"},
    {"solid outside the bounds", seed,
        solid("type sphere; centre (99 0 0); radius 2;"),
        "Solid beam is outside the bounds", "widen bounds"},
    {"solid called as a region", seed, [](systemCase& c)
        {
            const std::string all = c.text(file);
            const auto at = all.find_first_not_of(" \n{", all.find("regions")
                + 7);
            const std::string name =
                all.substr(at, all.find_first_of(" \n{", at) - at);
            c.add(file, "solids { " + name + " { " + beam + "} }");
        },
        "has the name of a region", "another name"},
    {"solids that overlap", seed, unplaced(solid
        (
            beam, "ball { type sphere; centre (5 1 1); radius 2; }"
        )),
        "Solids beam and ball overlap", "They may touch"},
    {"velocity of a solid of two components", seed, solid(beam + "U (1 2);"),
        "U has 2 values", "in parentheses"},
    {"part without nodes", seed,
        solid(beam + "parts { clamp { type box; min (7 7 7); max (8 8 8); } }"),
        "Part clamp of solid beam has no node; the solid reaches from (0 0 0)"
        " to (5 2 2)", "become the part"},
    {"part not a dictionary", seed, solid(beam + "parts { clamp box; }"),
        "Part clamp is not a dictionary", "Write clamp {"},
    {"neither fluid nor solids", seed, add(file, "fluid no;"),
        "nothing is seeded", "Add solids"},
};

} // namespace


TEST(badInput, solids)
{
    for (const breakage& b : solids)
    {
        expectRefused(b);
    }
}


TEST(badInput, seedParticlesDict)
{
    for (const breakage& b : dictionaries)
    {
        expectRefused(b);
    }
}
