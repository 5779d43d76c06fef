/* Calling the address of data. */
static char code[] = { 0x55, 0x31, 0x40 };

int main(void)
{
    int (*run)(void) = (int (*)(void)) code;

    return run(); // error: bad function pointer
}
