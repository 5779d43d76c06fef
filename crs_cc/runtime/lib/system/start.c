/* The beginning and the end of a program (C17 5.1.2.2). */
#include <crs_request.h>
#include <stdlib.h>
#include <string.h>

int main();

/* The program's constructors, a null pointer at the end; made by the linker. */
extern void (*__crs_starts[])(void);

/* The program's name, for messages: argv[0], and its part after the last slash. */
char *__progname_full = "";
const char *__progname = "";

/* Returns a copy of an argument, or a null pointer if there is none with that number. */
static char *read_argument(int number)
{
    struct __crs_message message;
    char *text = NULL;
    int length, done = 0;

    do {
        message.i[0] = number;
        message.i[1] = done;
        length = __crs_request(CRS_ARGUMENT, &message);
        if (length < 0)
            return NULL;
        if (text == NULL)
            text = malloc(length + 1);
        if (text == NULL || message.size <= 0)
            break;
        if (message.size > length - done)
            message.size = length - done;
        __builtin_memcpy(text + done, message.data, message.size);
        done += message.size;
    } while (done < length);
    if (text != NULL)
        text[done] = 0;
    return text;
}

static void name_program(char *path)
{
    char *slash = strrchr(path, '/');

    __progname_full = path;
    __progname = slash == NULL ? path : slash + 1;
}

/* The outermost function: collects the arguments, calls constructors and main, ends the program. */
int __crs_start(void)
{
    static char *environment[1];
    int count = 0, capacity = 8;
    char **arguments = malloc(capacity * sizeof *arguments);
    void (**each)(void);

    while (arguments != NULL && (arguments[count] = read_argument(count)) != NULL) {
        if (++count == capacity) {
            capacity *= 2;
            arguments = realloc(arguments, capacity * sizeof *arguments);
        }
    }
    if (count > 0)
        name_program(arguments[0]);
    for (each = __crs_starts; *each != NULL; each++)
        (*each)();
    exit(main(count, arguments, environment));
    return 0;
}
