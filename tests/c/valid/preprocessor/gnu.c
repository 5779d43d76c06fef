/* Extensions of gcc's preprocessor, and _Pragma. */
#include <stdio.h>

#warning "this is told and goes on"
#define LOG(format, ...) printf(format "\n" __VA_OPT__(,) __VA_ARGS__)
#define COUNT(args...) (sizeof (int[]){ args } / sizeof(int))
#define UNIQUE_(a, b) a##b
#define UNIQUE__(a, b) UNIQUE_(a, b)
#define UNIQUE UNIQUE__(name_, __COUNTER__)
#define QUIET(x) _Pragma("GCC diagnostic push") x; _Pragma("GCC diagnostic pop")
#pragma once
#ident "version 1"

static int UNIQUE = 1, UNIQUE = 2;

#import "imported.h"
#import "imported.h"
#define HEADER "imported.h"
#if __has_include(HEADER) && !__has_include("not_there.h")
static int headers = 1;
#endif
#ifdef __cplusplus
#else
static int gnu = 1;
#endif

int main(void)
{
    LOG("nothing");
    LOG("%d %d", 1, 2);
    printf("%u\n", (unsigned) COUNT(1, 2, 3));
    printf("%d %d\n", name_0, name_1);
    printf("%d\n", imported);
    QUIET(printf("%d %d\n", headers, gnu))
    printf("%d %s\n", __INCLUDE_LEVEL__, __BASE_FILE__[0] ? "named" : "?");
    return 0;
}
