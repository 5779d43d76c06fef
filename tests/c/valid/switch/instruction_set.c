/* A stack machine: one big switch in a loop. */
#include <stdio.h>

enum { PUSH, ADD, SUB, MUL, DUP, SWAP, LOAD, STORE, JUMP, JUMP_IF, CALL, RET, PRINT, HALT };

static int run(const int *code)
{
    int stack[32], calls[16], memory[8] = { 0 }, sp = 0, cp = 0, pc = 0, steps = 0, t;

    for (;; steps++) {
        switch (code[pc++]) {
        case PUSH: stack[sp++] = code[pc++]; break;
        case ADD: sp--; stack[sp - 1] += stack[sp]; break;
        case SUB: sp--; stack[sp - 1] -= stack[sp]; break;
        case MUL: sp--; stack[sp - 1] *= stack[sp]; break;
        case DUP: stack[sp] = stack[sp - 1]; sp++; break;
        case SWAP: t = stack[sp - 1]; stack[sp - 1] = stack[sp - 2]; stack[sp - 2] = t; break;
        case LOAD: stack[sp++] = memory[code[pc++]]; break;
        case STORE: memory[code[pc++]] = stack[--sp]; break;
        case JUMP: pc = code[pc]; break;
        case JUMP_IF: if (stack[--sp]) pc = code[pc]; else pc++; break;
        case CALL: calls[cp++] = pc + 1; pc = code[pc]; break;
        case RET: pc = calls[--cp]; break;
        case PRINT: printf("%d ", stack[--sp]); break;
        case HALT: return steps;
        default: return -1;
        }
    }
}

/* n = 1; f = 1; do { f *= n; print f; n++; } while (n - 11); the body is a subroutine */
static const int factorials[] = {
    /*  0 */ PUSH, 1, STORE, 0, PUSH, 1, STORE, 1,
    /*  8 */ CALL, 21,
    /* 10 */ LOAD, 0, PUSH, 11, SUB, JUMP_IF, 8, PUSH, -1, PRINT, HALT,
    /* 21 */ LOAD, 1, LOAD, 0, MUL, DUP, STORE, 1, PRINT,
    /* 30 */ LOAD, 0, PUSH, 1, ADD, STORE, 0, RET,
};

static const int countdown[] = { PUSH, 3, DUP, PRINT, PUSH, 1, SUB, DUP, JUMP_IF, 2, HALT };

int main(void)
{
    printf("%d\n", run(factorials));
    printf("%d\n", run(countdown));
    printf("%d\n", run((const int[]) { PUSH, 6, PUSH, 7, SWAP, SUB, PRINT, 99 }));
    return 0;
}
