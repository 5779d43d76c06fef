/* An interpreter of a small stack machine: a switch in a loop, as control programs have. */
#include <stdio.h>

enum { PUSH, ADD, SUB, MUL, DUP, LOAD, STORE, JUMP_IF, AND, HALT };

static int run(const int *code, int *steps)
{
    int stack[16], memory[4] = { 0 }, sp = 0, pc = 0;

    for (;; ++*steps)
        switch (code[pc++]) {
        case PUSH: stack[sp++] = code[pc++]; break;
        case ADD: sp--; stack[sp - 1] += stack[sp]; break;
        case SUB: sp--; stack[sp - 1] -= stack[sp]; break;
        case MUL: sp--; stack[sp - 1] *= stack[sp]; break;
        case AND: sp--; stack[sp - 1] &= stack[sp]; break;
        case DUP: stack[sp] = stack[sp - 1]; sp++; break;
        case LOAD: stack[sp++] = memory[code[pc++]]; break;
        case STORE: memory[code[pc++]] = stack[--sp]; break;
        case JUMP_IF: pc = stack[--sp] ? code[pc] : pc + 1; break;
        case HALT: return memory[1];
        }
}

static const int program[] = {
    /*  0 */ PUSH, 2000000, STORE, 0,
    /*  4 */ LOAD, 1, PUSH, 3, MUL, LOAD, 0, ADD, PUSH, 0xFFFF, AND, STORE, 1,
    /* 17 */ LOAD, 0, PUSH, 1, SUB, DUP, STORE, 0, JUMP_IF, 4, HALT,
};

int main(void)
{
    int steps = 0, result = run(program, &steps);

    printf("state_machine %d %d\n", result, steps);
    return 0;
}
