/* setjmp is never called. */
#include <setjmp.h>

static jmp_buf env;

int main(void)
{
    longjmp(env, 1); // error: longjmp without setjmp
}
