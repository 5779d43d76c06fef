/* Endless work through memory, without a request. */
// ends: running
static unsigned cells[1024];

int main(void)
{
    unsigned n = 1;

    while (1) {
        n = n * 1664525u + 1013904223u;
        cells[n >> 22] += n;
    }
}
