/* `#pragma weak`: names that need no definition, and aliases of functions and objects. */
#include <stdio.h>

#pragma weak hook
#pragma weak speed = fast
#pragma weak drive = slow
#pragma weak kept
#pragma weak puts
_Pragma("weak later = kept")

extern void hook(void);
extern int speed, missing;
int fast = 30;
int slow(int n) { return n / 2; }
int drive(int), later(void);
int kept(void) { return 4; }
#pragma weak missing

static int is_local_name_missing(void)
{
    extern int gone;
    return &gone == NULL;
}
#pragma weak gone

int main(void)
{
    puts(hook ? "a hook" : "no hook");
    puts(&missing ? "found" : "missing");
    speed++;
    printf("%d %d %d %d %d\n", fast, drive(8), kept(), later(), is_local_name_missing());
    return 0;
}
