/* The function that called setjmp has returned, and was called again. */
#include <setjmp.h>

static jmp_buf env;

static int prepare(void)
{
    return setjmp(env);
}

int main(void)
{
    if (prepare() == 0) {
        prepare();
        longjmp(env, 1); // error: longjmp to a function that has returned
    }
    return 0;
}
