/* Functions that run before main and after exit. */
#include <stdio.h>
#include <stdlib.h>

static void last(void) __attribute__((destructor(101)));
void first(void) __attribute__((constructor(101)));
static __attribute__((constructor)) void third(void) { puts("third"); }
__attribute__((constructor(102))) static void second(void) { puts("second"); }
void first(void) { puts("first"); }
static void last(void) { puts("last"); }
__attribute__((__destructor__)) static void seventh(void) { puts("seventh"); }
__attribute__((destructor)) static void sixth(void) { puts("sixth"); }
static void fifth(void) { puts("fifth"); }

int main(void)
{
    atexit(fifth);
    puts("main");
    exit(0);
}
