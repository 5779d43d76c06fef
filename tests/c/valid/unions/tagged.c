/* Tagged unions: an expression tree evaluated by kind. */
#include <stdio.h>

enum kind { NUMBER, ADD, MULTIPLY, NEGATE, CHOOSE };

struct expression {
    enum kind kind;
    union {
        double number;
        struct { const struct expression *left, *right; } pair;
        const struct expression *operand;
        struct { const struct expression *test, *yes, *no; } choice;
    } u;
};

static double evaluate(const struct expression *e)
{
    switch (e->kind) {
    case NUMBER:
        return e->u.number;
    case ADD:
        return evaluate(e->u.pair.left) + evaluate(e->u.pair.right);
    case MULTIPLY:
        return evaluate(e->u.pair.left) * evaluate(e->u.pair.right);
    case NEGATE:
        return -evaluate(e->u.operand);
    case CHOOSE:
        return evaluate(evaluate(e->u.choice.test) > 0 ? e->u.choice.yes : e->u.choice.no);
    }
    return 0;
}

int main(void)
{
    struct expression two = { NUMBER, { 2 } }, three = { NUMBER, { .number = 3.5 } };
    struct expression sum = { ADD, { .pair = { &two, &three } } };
    struct expression product = { MULTIPLY, { .pair = { &sum, &two } } };
    struct expression minus = { NEGATE, { .operand = &product } };
    struct expression pick = { CHOOSE, { .choice = { &minus, &two, &sum } } };

    printf("%g %g %g %g\n", evaluate(&sum), evaluate(&product), evaluate(&minus), evaluate(&pick));
    two.u.number = -10;
    printf("%g %g\n", evaluate(&minus), evaluate(&pick));
    return 0;
}
