/* The best of some candidates is kept by a pointer to a variable of the loop. */
#include <stdio.h>

struct candidate {
    int score, id;
};

int main(void)
{
    struct candidate kept = {0, 0};
    const struct candidate *best = &kept;

    for (int i = 1; i < 5; i++) {
        struct candidate now = {i * (6 - i), i};

        if (now.score <= best->score)
            continue;
        PLANT(best = &now, kept = now);
    }
    printf("%d\n", best->id); // error: use after scope
    return 0;
}
