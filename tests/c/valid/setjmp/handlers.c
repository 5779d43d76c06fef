/* Errors of a parser told by jumps: handlers in a list, one that throws again, one that is missing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct frame {
    jmp_buf env;
    struct frame *outer;
    int code;
    char text[40];
};

static struct frame *top;


static void throw(int code, const char *format, ...)
{
    va_list arguments;

    if (top == NULL) {
        printf("not caught: %d\n", code);
        exit(code);
    }
    va_start(arguments, format);
    vsnprintf(top->text, sizeof top->text, format, arguments);
    va_end(arguments);
    _longjmp(top->env, code);
}

static int parse(const char **text)
{
    int value = 0;

    if (**text == '(') {
        ++*text;
        value = parse(text);
        while (**text == '+' || **text == '-') {
            int sign = *(*text)++ == '+' ? 1 : -1;
            value += sign * parse(text);
        }
        if (*(*text)++ != ')')
            throw(2, "missing ')' before '%.3s'", *text - 1);
        return value;
    }
    if (**text < '0' || **text > '9')
        throw(1, "bad character '%c'", **text);
    while (**text >= '0' && **text <= '9')
        value = value * 10 + *(*text)++ - '0';
    return value;
}

static int evaluate(const char *text)
{
    struct frame here;
    int code;

    here.outer = top;
    top = &here;
    code = sigsetjmp(here.env, 1);
    if (code == 0) {
        int value = parse(&text);
        top = here.outer;
        return value;
    }
    top = here.outer;
    if (top != NULL && code == 2) {
        strcat(here.text, " again");
        throw(3, "%s", here.text);
    }
    printf("error %d: %s\n", code, here.text);
    return -1;
}

int main(void)
{
    static const char *texts[] = {"12", "(1+2-(3+4))", "(1*2)", "((1+2)", "x", "(1-(2-(3-4)))"};
    int i, round;

    for (round = 0; round < 2; round++)
        for (i = 0; i < 6; i++) {
            struct frame outer;
            int code;
            if (round == 0) {
                printf("%s = %d\n", texts[i], evaluate(texts[i]));
                continue;
            }
            outer.outer = NULL;
            top = &outer;
            if ((code = setjmp(outer.env)) == 0)
                printf("%s = %d\n", texts[i], evaluate(texts[i]));
            else
                printf("outer %d: %s\n", code, outer.text);
            top = NULL;
        }
    throw(5, "end");
    return 0;
}
// exit: 5
