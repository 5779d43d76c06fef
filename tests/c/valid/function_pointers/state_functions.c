/* A state machine whose states are functions that return the next state. */
#include <stdio.h>
#include <ctype.h>

struct state;
typedef struct state (*step)(int c);
struct state { step next; };

static int numbers, words, depth;

static struct state idle(int c);
static struct state number(int c);
static struct state word(int c);

static struct state idle(int c)
{
    struct state s = { idle };

    if (isdigit(c))
        numbers++, s.next = number;
    else if (isalpha(c))
        words++, s.next = word;
    else if (c == '(')
        depth++;
    return s;
}

static struct state number(int c)
{
    return isdigit(c) || c == '.' ? (struct state) { number } : idle(c);
}

static struct state word(int c)
{
    struct state s;

    s.next = isalnum(c) ? word : 0;
    return s.next ? s : idle(c);
}

int main(void)
{
    const char *text = "vm(100, 3.14, x2) + sonar15 42 (7)";
    struct state s = { idle };

    while (*text) {
        s = s.next(*text++);
        putchar(s.next == idle ? '.' : s.next == number ? 'n' : 'w');
    }
    printf("\n%d %d %d\n", numbers, words, depth);
    return 0;
}
