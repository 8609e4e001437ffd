# Rows x y z cell m rho U; writes new.positions, .m, .rho, .U, one value a line.
# pair: a particle beside the middle of a vortex moves to 0.01 h from the next
# void: those within 3 h of the middle of a vortex are gone
# jump: where x < 1/2 each becomes four of half the spacing

function put(x, y, m)
{
    print "(" x " " y " 0) 0" > "new.positions"
    print m > "new.m"
    print $6 > "new.rho"
    k = 8*atan2(1, 1)
    printf "(%.16g %.16g 0)\n", sin(k*x)*cos(k*y), -cos(k*x)*sin(k*y) > "new.U"
}

BEGIN {
    OFMT = CONVFMT = "%.16g"
    h = 1/n
    if (kind != "pair" && kind != "void" && kind != "jump")
    {
        print "Unknown arrangement " kind > "/dev/stderr"
        exit 1
    }
}

{
    far = sqrt(($1 - 0.25)^2 + ($2 - 0.25)^2)/h
}

kind == "pair" {
    # The one above and to the right of the middle goes to its left neighbour
    isIt = $1 > 0.25 && $1 <= 0.25 + h && $2 > 0.25 && $2 <= 0.25 + h
    put(isIt ? $1 - 0.99*h : $1, $2, $5)
}

kind == "void" && far > 3 { put($1, $2, $5) }

kind == "jump" && $1 >= 0.5 { put($1, $2, $5) }

kind == "jump" && $1 < 0.5 {
    for (i = -1; i < 2; i += 2)
    {
        for (j = -1; j < 2; j += 2)
        {
            put($1 + i*h/4, $2 + j*h/4, $5/4)
        }
    }
}
