/* Reads at addresses far apart; the first one ends it. */
// ends: pointer outside memory
static volatile unsigned sum;

int main(void)
{
    unsigned at;

    for (at = 0x01000000; at != 0; at += 0x00010000)
        sum += *(volatile unsigned char *) at;
    return 0;
}
