/* A function that is declared weak, and defined nowhere, is called. */
__attribute__((weak)) int hook(int);

int main(void)
{
    return hook(2); // error: bad function pointer
}
