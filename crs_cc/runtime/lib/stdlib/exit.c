/* Ways to end a program (C17 7.22.4; on_exit: BSD). */
#include <crs_request.h>
#include <stdlib.h>
#include <unistd.h>

#include <crs/signals.h>
#include <crs/stream.h>

/* A function to be called at the end: of atexit, or of on_exit with its argument. */
struct handler {
    void (*plain)(void);
    void (*with_status)(int status, void *argument);
    void *argument;
};

/* Handlers in blocks of 32, the number that C17 7.22.4.2 guarantees; more blocks on demand. */
struct handlers {
    struct handlers *earlier;
    int count;
    struct handler handler[32];
};

static struct handlers first_block;
static struct handlers *last_block = &first_block;

/* The program's destructors, a null pointer at the end; made by the linker. */
extern void (*__crs_ends[])(void);
static void (**next_end)(void) = __crs_ends;

static int add(struct handler handler)
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

int atexit(void (*handler)(void))
{
    struct handler each = {handler, NULL, NULL};

    return add(each);
}

int on_exit(void (*handler)(int status, void *argument), void *argument)
{
    struct handler each = {NULL, handler, argument};

    return add(each);
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

static void run(const struct handler *handler, int status)
{
    if (handler->plain != NULL)
        handler->plain();
    else if (handler->with_status != NULL)
        handler->with_status(status, handler->argument);
}

/* Handlers run last in, first out; one of them may call exit itself, or register more. */
_Noreturn void exit(int status)
{
    for (;;) {
        while (last_block->count == 0 && last_block->earlier != NULL)
            last_block = last_block->earlier;
        if (last_block->count == 0)
            break;
        run(&last_block->handler[--last_block->count], status);
    }
    while (*next_end != NULL)
        (*next_end++)();
    __crs_flush_all();
    end_program(status);
}

void (*__crs_on_abort)(void);

/* A handler of SIGABRT runs first, and may leave by longjmp (C17 7.22.4.1). */
_Noreturn void abort(void)
{
    if (__crs_on_abort != NULL)
        __crs_on_abort();
    for (;;)
        __crs_stop("abort called");
}

/* Functions called by quick_exit (C17 7.22.4.7). */
static void (*quick_handlers[32])(void);
static int quick_count;

int at_quick_exit(void (*handler)(void))
{
    if (quick_count == 32)
        return -1;
    quick_handlers[quick_count++] = handler;
    return 0;
}

_Noreturn void quick_exit(int status)
{
    while (quick_count > 0)
        quick_handlers[--quick_count]();
    end_program(status);
}
