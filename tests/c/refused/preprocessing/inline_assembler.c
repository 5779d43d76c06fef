/* Machine code cannot be compiled for another machine. */
int main(void)
{
    __asm__("cli"); // error: assembly
    return 0;
}
