/* An element of an array that is declared weak, and defined nowhere, is written. */
extern int table[4] __attribute__((weak));

int main(void)
{
    table[1] = 3; // error: null pointer
    return 0;
}
