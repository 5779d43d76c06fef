/* Jumps out of functions (C17 7.13.2); the other half is the compiler's. */
#include <crs/automatic.h>
#include <setjmp.h>

/* Counts the calls of functions that call setjmp. */
unsigned __crs_activations;

void longjmp(jmp_buf buffer, int value)
{
    if (buffer->activation == 0)
        __crs_stop("longjmp without setjmp");
    __crs_release(buffer->automatic);
    __crs_longjmp(buffer->activation, buffer->place, value != 0 ? value : 1);
}

void _longjmp(jmp_buf buffer, int value)
{
    longjmp(buffer, value);
}
