/* Reads every address there is, from the bottom. */
// ends: null pointer
static volatile unsigned sum;

int main(void)
{
    unsigned address;

    for (address = 0; address < 0xFFFFFFF0u; address += 16)
        sum += *(unsigned char *) address;
    return 0;
}
