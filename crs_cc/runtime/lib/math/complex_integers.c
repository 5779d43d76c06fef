/* Quotients of complex integers, as gcc computes them: by R. L. Smith's method (CACM 1962,
   algorithm 116), each of whose quotients is truncated. */

/* The name of a function, and the type of the parts. */
#define QUOTIENT(name, T) \
    T _Complex name(T a, T b, T c, T d); \
    T _Complex name(T a, T b, T c, T d) \
    { \
        T _Complex result; \
        T ratio, divisor; \
        if (MAGNITUDE(c) < MAGNITUDE(d)) { \
            ratio = c / d; \
            divisor = c * ratio + d; \
            __real__ result = (a * ratio + b) / divisor; \
            __imag__ result = (b * ratio - a) / divisor; \
        } else { \
            ratio = d / c; \
            divisor = d * ratio + c; \
            __real__ result = (b * ratio + a) / divisor; \
            __imag__ result = (b - a * ratio) / divisor; \
        } \
        return result; \
    }

#define MAGNITUDE(x) ((x) < 0 ? -(x) : (x))
QUOTIENT(__crs_quotient_signed, long long)
#undef MAGNITUDE
#define MAGNITUDE(x) (x)
QUOTIENT(__crs_quotient_unsigned32, unsigned)
QUOTIENT(__crs_quotient_unsigned64, unsigned long long)
