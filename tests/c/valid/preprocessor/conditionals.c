/* #if, #ifdef, #elif, #else, defined, nested and skipped. */
#include <stdio.h>

#define VERSION 204
#define FEATURE_A
#define ZERO 0
#define EMPTY

int main(void)
{
#if VERSION >= 200 && VERSION < 300
    printf("two\n");
#elif VERSION >= 300
    printf("three\n");
#else
#error not reached
#endif
#ifdef FEATURE_A
    printf("A\n");
# ifndef FEATURE_B
    printf("not B\n");
#  if 0
    this is not C at all 'unbalanced "
#  else
    printf("else of 0\n");
#  endif
# endif
#else
    printf("no A\n");
#endif
#if defined(FEATURE_A) && !defined FEATURE_B && defined EMPTY
    printf("defined\n");
#endif
#if ZERO || UNKNOWN || (1 ? 0 : 1)
    printf("never\n");
#elif (VERSION / 100 == 2) && (VERSION % 100) == 4 && (1 << 3 | 1) == 9 && -1 < 0 && 'A' == 65
    printf("arithmetic\n");
#endif
#if 0
# if 1
    printf("never\n");
# elif 1
# else
# endif
#elif 1
    printf("elif\n");
#elif 1 / 0
    printf("not evaluated\n");
#endif
#if 0xFFFFFFFF > 0 && 2147483647 + 1 > 0 && -1 > 0u && ~0 == -1
    printf("64 bits\n");
#endif
#ifdef __LINE__
    printf("builtin\n");
#endif
#undef FEATURE_A
#undef NEVER_DEFINED
#ifndef FEATURE_A
    printf("undefined again\n");
#endif
    return 0;
}
