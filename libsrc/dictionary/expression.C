#include "dictionary/expression.H"

#include "dictionary/number.H"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <omp.h>

namespace gpuFsi
{

static void defineNames(mu::Parser& parser)
{
    using f1 = double (*)(double);
    using f2 = double (*)(double, double);
    using f3 = double (*)(double, double, double);
    const auto one = [&](const char* name, f1 f) { parser.DefineFun(name, f); };
    const auto two = [&](const char* name, f2 f) { parser.DefineFun(name, f); };

    parser.DefineConst("pi", 3.14159265358979323846);
    parser.DefineConst("e", 2.71828182845904523536);
    parser.DefineInfixOprt("!", [](double s) { return s == 0 ? 1.0 : 0.0; });
    one("sqr", [](double s) { return s*s; });
    one("mag", [](double s) { return std::fabs(s); });
    one("pos", [](double s) { return s > 0 ? 1.0 : 0.0; });
    one("pos0", [](double s) { return s >= 0 ? 1.0 : 0.0; });
    one("neg", [](double s) { return s < 0 ? 1.0 : 0.0; });
    one("floor", [](double s) { return std::floor(s); });
    one("ceil", [](double s) { return std::ceil(s); });
    two("pow", [](double s, double n) { return std::pow(s, n); });
    two("mod", [](double s, double n) { return std::fmod(s, n); });
    // Bessel functions of the first kind, of whole order n
    one("j0", [](double s) { return ::j0(s); });
    one("j1", [](double s) { return ::j1(s); });
    two("jn", [](double n, double s)
    {
        return n == std::rint(n) ? ::jn(int(n), s) : std::nan("");
    });
    parser.DefineFun
    (
        "if",
        f3([](double c, double a, double b) { return c != 0 ? a : b; })
    );
}


//- muParser would assign at a single '='
static void refuseAssignment(const std::string& text, const sourceSpan& where)
{
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] != '=')
        {
            continue;
        }
        if (i + 1 < text.size() && text[i + 1] == '=')
        {
            ++i;
        }
        else if (i == 0 || !std::strchr("<>!", text[i - 1]))
        {
            throw userError
            (
                "Expression '" + text + "' has an assignment at position "
                    + std::to_string(i + 1),
                where,
                "Compare with ==; nothing can be assigned."
            );
        }
    }
}


//- `pi()` of OpenFOAM.com as the constant pi; positions stay
static std::string withPlainPi(std::string text)
{
    for
    (
        std::size_t i = text.find("pi()");
        i != std::string::npos;
        i = text.find("pi()", i + 1)
    )
    {
        if (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1])))
        {
            text.replace(i + 2, 2, "  ");
        }
    }
    return text;
}


namespace
{

struct formula
{
    std::string text;
    sourceSpan where;
    mu::Parser parser;
    double x = 0, y = 0, z = 0, r = 0, t = 0;

    formula
    (
        const std::string& expressionText,
        const sourceSpan& place,
        bool withVariables
    )
    :
        text(expressionText),
        where(place)
    {
        refuseAssignment(text, where);
        try
        {
            defineNames(parser);
            if (withVariables)
            {
                parser.DefineVar("x", &x);
                parser.DefineVar("y", &y);
                parser.DefineVar("z", &z);
                parser.DefineVar("r", &r);
                parser.DefineVar("t", &t);
            }
            parser.SetExpr(withPlainPi(text));
            parser.Eval();
        }
        catch (const mu::Parser::exception_type& e)
        {
            fail(e, withVariables);
        }
        if (parser.GetNumResults() != 1)
        {
            throw userError
            (
                "Expression '" + text + "' has several values",
                where,
                "One value is needed: remove the comma outside parentheses."
            );
        }
    }

    [[noreturn]] void fail
    (
        const mu::Parser::exception_type& e,
        bool withVariables
    ) const
    {
        const std::size_t position =
            std::min<std::size_t>(e.GetPos(), text.size()) + 1;
        throw userError
        (
            "Expression '" + text + "' cannot be read at position "
                + std::to_string(position) + ": " + e.GetMsg(),
            where,
            std::string("Known are ")
                + (withVariables ? "x y z r t, " : "")
                + "pi e, + - * / ^ < <= == != > >= && || ! c ? a : b, and"
                  " functions such as sqrt exp log sin cos min max pow sqr"
                  " mag pos neg. C++ code is not run."
        );
    }

    double value(const vector& p, double time)
    {
        x = p.x;
        y = p.y;
        z = p.z;
        r = std::sqrt(x*x + y*y + z*z);
        t = time;
        return parser.Eval();
    }
};

} // namespace


struct expression::implementation
:
    formula
{
    implementation(const std::string& text, const sourceSpan& where)
    :
        formula(text, where, true)
    {}
};


expression::expression(const std::string& text, const sourceSpan& where)
:
    impl_(std::make_unique<implementation>(text, where))
{}


expression::~expression() = default;
expression::expression(expression&&) noexcept = default;
expression& expression::operator=(expression&&) noexcept = default;


double expression::operator()(const vector& p, double t) const
{
    return impl_->value(p, t);
}


const std::string& expression::text() const
{
    return impl_->text;
}


bool expression::uses(const std::string& variable) const
{
    return impl_->parser.GetUsedVar().count(variable) > 0;
}


std::vector<double> expression::at
(
    const std::vector<vector>& points,
    double t
) const
{
    const long n = long(points.size());
    std::vector<double> values(points.size());

    // A parser costs about as much as a thousand evaluations
    const int nThreads =
        std::max(1, int(std::min<long>(omp_get_max_threads(), n/4096)));
    std::vector<std::unique_ptr<implementation>> parsers;
    for (int i = 0; i < nThreads; ++i)
    {
        parsers.push_back
        (
            std::make_unique<implementation>(impl_->text, impl_->where)
        );
    }
    #pragma omp parallel for schedule(static) num_threads(nThreads)
    for (long i = 0; i < n; ++i)
    {
        values[i] = parsers[omp_get_thread_num()]->value(points[i], t);
    }

    for (long i = 0; i < n; ++i)
    {
        if (!std::isfinite(values[i]))
        {
            const vector& p = points[i];
            throw userError
            (
                "Expression '" + impl_->text + "' is "
                    + numberText(values[i]) + " at the point ("
                    + numberText(p.x) + ' ' + numberText(p.y) + ' '
                    + numberText(p.z) + "), t = " + numberText(t),
                impl_->where,
                "Guard the singular point, as in r > 0 ? 1/r : 0."
            );
        }
    }
    return values;
}


double evaluate(const std::string& text, const sourceSpan& where)
{
    const double value = formula(text, where, false).parser.Eval();
    if (!std::isfinite(value))
    {
        throw userError
        (
            "Expression '" + text + "' is " + numberText(value),
            where,
            "Is there a division by zero, or the root of a negative number?"
        );
    }
    return value;
}

} // namespace gpuFsi
