/* What a loop's body keeps of one turn is gone in the next. */
struct reading { int sonar, distance; };

int main(void)
{
    struct reading *best = 0;
    int i;

    for (i = 0; i < 3; i++) {
        struct reading now;
        now.sonar = i;
        now.distance = 10 - i;
        if (best == 0)
            best = &now;
    }
    return best->distance; // error: use after scope
}
