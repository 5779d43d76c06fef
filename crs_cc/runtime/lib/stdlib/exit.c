/* Ways to end a program (C17 7.22.4). */
#include <crs_request.h>
#include <stdlib.h>
#include <unistd.h>

#include <crs/stream.h>

/* Handlers in blocks of 32, the number that C17 7.22.4.2 guarantees; more blocks on demand. */
struct handlers {
    struct handlers *earlier;
    int count;
    void (*handler[32])(void);
};

static struct handlers first_block;
static struct handlers *last_block = &first_block;

/* The program's destructors, a null pointer at the end; made by the linker. */
extern void (*__crs_ends[])(void);
static void (**next_end)(void) = __crs_ends;

int atexit(void (*handler)(void))
{
    if (last_block->count == 32) {
        struct handlers *block = malloc(sizeof *block);
        if (block == NULL)
            return -1;
        block->earlier = last_block;
        block->count = 0;
        last_block = block;
    }
    last_block->handler[last_block->count++] = handler;
    return 0;
}

static _Noreturn void end_program(int status)
{
    struct __crs_message message;

    for (;;) {
        message.i[0] = status;
        __crs_request(CRS_EXIT, &message);
    }
}

_Noreturn void _Exit(int status)
{
    end_program(status);
}

_Noreturn void _exit(int status)
{
    end_program(status);
}

/* Handlers run last in, first out; one of them may call exit itself, or register more. */
_Noreturn void exit(int status)
{
    for (;;) {
        while (last_block->count == 0 && last_block->earlier != NULL)
            last_block = last_block->earlier;
        if (last_block->count == 0)
            break;
        last_block->handler[--last_block->count]();
    }
    while (*next_end != NULL)
        (*next_end++)();
    __crs_flush_all();
    end_program(status);
}

_Noreturn void abort(void)
{
    for (;;)
        __crs_stop("abort called");
}
