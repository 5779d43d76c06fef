/* Symbols that are declared `weak` and not defined have the address 0. */
#include <stdio.h>

__attribute__((weak)) void hook(void);
extern int later(int) __attribute__((weak));
extern int setting __attribute__((weak)), table[4] __attribute__((weak));
extern struct { int a, b; } pair __attribute__((weak));

static struct {
    void (*call)(void);
    int *element, *member;
} kept = {hook, &table[2], &pair.b};

static void call(void (*given)(void))
{
    if (given)
        given();
    else
        puts("none given");
}

int main(void)
{
    if (hook)
        hook();
    else
        puts("no hook");
    printf("%d\n", later ? later(1) : -1);
    printf("%d\n", &setting != NULL ? setting : -2);
    puts(table ? "a table" : "no table");
    printf("%d %d %d\n", kept.call == 0, (int) kept.element, (int) kept.member);
    printf("%d\n", hook && later(2));
    call(hook), call(kept.call);
    return 0;
}
