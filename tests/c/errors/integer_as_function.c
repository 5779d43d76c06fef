/* Calling an integer. */
int main(void)
{
    void (*jump)(void) = (void (*)(void)) 0x12345678;

    jump(); // error: bad function pointer
    return 0;
}
