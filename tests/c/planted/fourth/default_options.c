/* Options default to a compound literal in an inner block. */
#include <stdio.h>

struct options {
    int speed, turns;
};

static int run(const struct options *options)
{
    struct options standard = {20, 2};

    if (options == NULL) {
        options = PLANT((&(struct options){20, 2}), &standard);
    }
    return options->speed * options->turns; // error: use after scope
}

int main(void)
{
    printf("%d\n", run(NULL));
    return 0;
}
