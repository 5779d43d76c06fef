/* Tables of functions: a calculator, a dispatcher, commands by name. */
#include <stdio.h>
#include <string.h>

static int add(int a, int b) { return a + b; }
static int sub(int a, int b) { return a - b; }
static int mul(int a, int b) { return a * b; }
static int div_(int a, int b) { return b ? a / b : -1; }

static int (*const operations[])(int, int) = { add, sub, mul, div_ };

struct command { const char *name; void (*run)(const char *argument); int needs_argument; };

static void say(const char *s) { printf("say %s\n", s); }
static void beep(const char *s) { printf("beep%s\n", s ? s : ""); }
static void quit(const char *s) { (void) s; printf("quit\n"); }

static struct command commands[] = {
    { "say", say, 1 }, { "beep", &beep, 0 }, { "quit", quit, 0 }, { 0, 0, 0 },
};

static int run(const char *name, const char *argument)
{
    struct command *c;

    for (c = commands; c->name; c++)
        if (strcmp(c->name, name) == 0) {
            if (c->needs_argument && !argument)
                return -1;
            c->run(argument);
            return 1;
        }
    return 0;
}

int main(void)
{
    int i;
    int (*f)(int, int) = add;

    for (i = 0; i < 4; i++)
        printf("%d ", operations[i](20, 6));
    printf("%d\n", operations[3](1, 0));
    printf("%d %d %d\n", f(1, 2), (*f)(3, 4), (**f)(5, 6));
    printf("%d %d\n", f == add, f != &add);
    f = operations[2];
    printf("%d %d\n", f == mul, f(7, 8));
    printf("%d ", run("say", "hello"));
    printf("%d %d ", run("say", 0), run("jump", 0));
    printf("%d ", run("quit", 0));
    printf("%d\n", run("beep", "!"));
    return 0;
}
