/* A jmp_buf filled with nonsense behind a true beginning. */
// ends: corrupted stack
#include <setjmp.h>

int main(void)
{
    jmp_buf env;

    if (setjmp(env) == 0) {
        ((unsigned *)env)[1] = 0x7fffffff;
        longjmp(env, 1);
    }
    return 0;
}
