/* An index far behind a global array, but in its red zone. */
static int table[64];

int main(void)
{
    volatile int i = 70;

    table[i] = 1; // error: out of bounds
    return 0;
}
