/* An interpreter of a small stack machine, which runs a loop with a call and an array. */
#include <stdio.h>

enum { PUSH, LOAD, STORE, ADD, SUB, MUL, MOD, LESS, JUMP, JZERO, CALL, RETURN, GET, PUT, HALT };

struct machine {
    const int *code;
    int pc, sp, rp;
    int stack[64], calls[16], variables[8], memory[256];
};

static int run(struct machine *m)
{
    for (;;) {
        int op = m->code[m->pc++], a;
        switch (op) {
        case PUSH: m->stack[m->sp++] = m->code[m->pc++]; break;
        case LOAD: m->stack[m->sp++] = m->variables[m->code[m->pc++]]; break;
        case STORE: m->variables[m->code[m->pc++]] = m->stack[--m->sp]; break;
        case ADD: a = m->stack[--m->sp]; m->stack[m->sp - 1] += a; break;
        case SUB: a = m->stack[--m->sp]; m->stack[m->sp - 1] -= a; break;
        case MUL: a = m->stack[--m->sp]; m->stack[m->sp - 1] *= a; break;
        case MOD: a = m->stack[--m->sp]; m->stack[m->sp - 1] %= a; break;
        case LESS: a = m->stack[--m->sp]; m->stack[m->sp - 1] = m->stack[m->sp - 1] < a; break;
        case JUMP: m->pc = m->code[m->pc]; break;
        case JZERO:
            a = m->code[m->pc++];
            if (m->stack[--m->sp] == 0)
                m->pc = a;
            break;
        case CALL: m->calls[m->rp++] = m->pc + 1; m->pc = m->code[m->pc]; break;
        case RETURN: m->pc = m->calls[--m->rp]; break;
        case GET: m->stack[m->sp - 1] = m->memory[m->stack[m->sp - 1] & 255]; break;
        case PUT: a = m->stack[--m->sp]; m->memory[a & 255] = m->stack[--m->sp]; break;
        case HALT: return m->variables[1];
        default: return -1;
        }
    }
}

int main(void)
{
    static const int code[] = {
        /* 0 */ PUSH, 0, STORE, 0, PUSH, 1, STORE, 1,
        /* 8 */ LOAD, 0, PUSH, 400000, LESS, JZERO, 24,
        /* 15 */ CALL, 25, LOAD, 0, PUSH, 1, ADD, JUMP, 46,
        /* 24 */ HALT,
        /* 25 */ LOAD, 1, PUSH, 31, MUL, LOAD, 0, GET, ADD, PUSH, 9973, MOD, STORE, 1,
        /* 39 */ LOAD, 1, LOAD, 0, PUT, RETURN, HALT,
        /* 46 */ STORE, 0, JUMP, 8,
    };
    static struct machine m;
    int round, sum = 0;

    m.code = code;
    for (round = 0; round < 4; round++) {
        m.pc = m.sp = m.rp = 0;
        sum = sum * 3 + run(&m);
    }
    printf("small_vm %d\n", sum);
    return 0;
}
