/* Predefined macros that programs choose by, with gcc's values on i386. */
#include <stdio.h>

#define SHOW(x) printf(#x " %lld\n", (long long)(x))
#define NAME(x) puts(#x " " STR(x))
#define STR(x) #x

int main(void)
{
    SHOW(__STDC__); SHOW(__STDC_VERSION__); SHOW(__STDC_HOSTED__); SHOW(__CHAR_BIT__);
    SHOW(__i386__); SHOW(__linux__); SHOW(__unix__); SHOW(linux); SHOW(unix); SHOW(i386);
    SHOW(__ILP32__); SHOW(__ELF__); SHOW(__BYTE_ORDER__); SHOW(__ORDER_LITTLE_ENDIAN__);
    SHOW(__SCHAR_MAX__); SHOW(__SHRT_MAX__); SHOW(__INT_MAX__); SHOW(__LONG_MAX__);
    SHOW(__LONG_LONG_MAX__); SHOW(__SIZE_MAX__); SHOW(__PTRDIFF_MAX__); SHOW(__INTMAX_MAX__);
    SHOW(__INT_FAST16_MAX__); SHOW(__UINT_LEAST8_MAX__); SHOW(__SIZEOF_INT__);
    SHOW(__SIZEOF_LONG__); SHOW(__SIZEOF_POINTER__); SHOW(__SIZEOF_LONG_LONG__);
    SHOW(__SIZEOF_SIZE_T__); SHOW(__SIZEOF_WCHAR_T__); SHOW(__SIZEOF_DOUBLE__);
    SHOW(__INT_WIDTH__); SHOW(__LONG_WIDTH__); SHOW(__BIGGEST_ALIGNMENT__);
    SHOW(__FLT_MANT_DIG__); SHOW(__DBL_MAX_EXP__); SHOW(__DBL_DIG__); SHOW(__FLT_RADIX__);
    NAME(__SIZE_TYPE__); NAME(__WCHAR_TYPE__); NAME(__INT64_TYPE__); NAME(__UINT_FAST16_TYPE__);
    printf("[" STR(__USER_LABEL_PREFIX__) "]\n");
#ifdef __STRICT_ANSI__
    puts("strict");
#endif
    return 0;
}
