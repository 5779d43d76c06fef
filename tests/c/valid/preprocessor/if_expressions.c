/* #if expressions: 64-bit arithmetic, identifiers evaluate to 0, short-circuit evaluation (C17 6.10.1). */
#include <stdio.h>
#include <limits.h>

#define YES 1
#define TEXT(x) puts(#x)
#define TWICE(x) (2 * (x))

int main(void)
{
#if 1 + 2 * 3 == 7 && (8 >> 1 | 1) == 5
    TEXT(arithmetic);
#endif
#if -1 > 0u
    TEXT(unsigned wins);
#endif
#if 0x7fffffff + 1 > 0
    TEXT(wide);
#endif
#if undefined_name || defined undefined_name || !defined(YES)
    TEXT(wrong);
#elif TWICE(YES) == 2 ? 1 : 1 / 0
    TEXT(lazy);
#elif 1 / 0
    TEXT(not read);
#endif
#if 'a' == 97 && '\n' == 10 && '\377' < 0
    TEXT(characters);
#endif
#if 0 && 1 / 0 || 1 || 1 % 0
    TEXT(short circuit);
#endif
#if INT_MAX == 2147483647 && LONG_MAX == INT_MAX && ULLONG_MAX > LLONG_MAX
    TEXT(limits);
#endif
#if (2, 3) == 3 || 1
    TEXT(comma);
#endif
#if 0
#if 1
    TEXT(wrong);
#else
# error not here
#endif
    it's not C
#elif defined(YES)
#  if ~0 == -1 && -7 / 2 == -3 && -7 % 2 == -1
    TEXT(nested);
#  endif
#else
    TEXT(wrong);
#endif
#ifndef undefined_name
#undef undefined_name
    TEXT(not defined);
#endif
#if 0xffffffffffffffff == -1 && 18446744073709551615u == ~0
    TEXT(all bits);
#endif
    return 0;
}
