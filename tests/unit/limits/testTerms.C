#include "limits/termLimits.H"
