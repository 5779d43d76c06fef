/* Labels as values: a stack machine with a table, static and local tables, offsets, states. */
#include <stdio.h>

enum { PUSH, ADD, MUL, DUP, JNZ, DEC, SWAP, PRINT, HALT };

static int run(const signed char *code)
{
    static const void *const table[] = {
        [PUSH] = &&push, [ADD] = &&add, [MUL] = &&mul, [DUP] = &&dup, [JNZ] = &&jnz,
        [DEC] = &&dec, [SWAP] = &&swap, [PRINT] = &&print, [HALT] = &&halt,
    };
    int stack[16], *top = stack, steps = 0;
#define NEXT do { steps++; goto *table[*code++]; } while (0)

    NEXT;
push:
    *top++ = *code++;
    NEXT;
add:
    top--;
    top[-1] += *top;
    NEXT;
mul:
    top--;
    top[-1] *= *top;
    NEXT;
dup:
    *top = top[-1];
    top++;
    NEXT;
jnz:
    if (*--top)
        code += *code;
    else
        code++;
    NEXT;
dec:
    top[-1]--;
    NEXT;
swap: {
    int t = top[-1];
    top[-1] = top[-2];
    top[-2] = t;
    NEXT;
}
print:
    printf("%d ", top[-1]);
    NEXT;
halt:
    return steps;
}

static int words(const char *text)
{
    void *state = &&outside;
    int count = 0;

    for (; *text; text++) {
        goto *state;
    outside:
        if (*text != ' ') {
            count++;
            state = &&inside;
        }
        continue;
    inside:
        if (*text == ' ')
            state = &&outside;
    }
    return count;
}

static int offsets(int which)
{
    static const int table[] = {&&a - &&a, &&b - &&a, &&c - &&a};
    void *back = &&done;
    int result = 0;

    goto *(&&a + table[which]);
c:
    result += 100;
b:
    result += 10;
a:
    result += 1;
    goto *back;
done:
    return back == &&done && back != &&a ? result : -1;
}

#define find(array, count, value) ({ \
    __label__ found, out; \
    int i_; \
    for (i_ = 0; i_ < (count); i_++) \
        if ((array)[i_] == (value)) \
            goto found; \
    i_ = -1; \
    goto out; \
found: \
    i_ += 1000; \
out: \
    i_; })

int main(void)
{
    /* factorial of 6, then a loop */
    static const signed char code[] = {
        PUSH, 1, PUSH, 6, DUP, JNZ, 4, PUSH, 0, HALT, DUP, PRINT, SWAP, PUSH, 2, MUL, SWAP, DEC,
        DUP, JNZ, -10, SWAP, PRINT, HALT,
    };
    int primes[] = {2, 3, 5, 7, 11};

    printf("%d\n", run(code));
    printf("%d %d\n", words("  the quick  brown fox "), words(""));
    printf("%d %d %d\n", offsets(0), offsets(1), offsets(2));
    printf("%d %d\n", find(primes, 5, 7), find(primes, 5, 8));
    return 0;
}
