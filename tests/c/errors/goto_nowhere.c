/* A computed goto whose target is not the address of a label. */
int main(int argc, char **argv)
{
    void *table[] = {&&end, 0};

    goto *table[argc]; // error: invalid goto target
end:
    return 0;
}
